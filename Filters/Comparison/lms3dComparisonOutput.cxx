// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dComparisonOutput.h"

#include "Comparison/lms3dErrorStatistics.h"
#include "Pipeline/lms3dArray.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& values)
{
  auto array = lms3dMakeArray<vtkDoubleArray>(name, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void Add(const char* name, double value, vtkFieldData* output)
{
  lms3dAddHiddenArray(MakeArray(name, { value }), output);
}

void Add(const char* name, const lms3dErrorStatistics& errors, vtkFieldData* output)
{
  auto array = lms3dMakeArray<vtkDoubleArray>(name, 1, 4);
  array->SetComponentName(0, "Mean");
  array->SetComponentName(1, "RMS");
  array->SetComponentName(2, "95 %");
  array->SetComponentName(3, "Maximum");
  array->SetTuple4(0, errors.Mean, errors.RootMeanSquare, errors.Percentile95, errors.Maximum);
  lms3dAddHiddenArray(array, output);
}

// Takes the vertices as well as the samples, since a small cell may have no sample.
std::vector<double> GetLargestErrors(const lms3dTriangleMesh& map, const lms3dMapErrors& errors,
  const std::vector<double>& vertexErrors, vtkIdType cells)
{
  std::vector<double> largest(cells, std::numeric_limits<double>::quiet_NaN());
  const auto take = [&](std::size_t triangle, double error)
  {
    double& cell = largest[map.GetCell(triangle)];
    cell = std::fmax(cell, error);
  };
  for (std::size_t triangle = 0; triangle < map.GetNumberOfTriangles(); ++triangle)
  {
    for (std::uint32_t corner : map.Triangles[triangle])
    {
      take(triangle, vertexErrors[corner]);
    }
  }
  for (std::size_t i = 0; i < errors.Distances.size(); ++i)
  {
    take(errors.Samples.Triangles[i], errors.Distances[i]);
  }
  return largest;
}
} // namespace

void lms3dAddErrors(const lms3dTriangleMesh& map, const lms3dMapErrors& errors,
  const std::vector<double>& vertexErrors, vtkPolyData* output)
{
  output->GetPointData()->SetScalars(MakeArray("Error", vertexErrors));
  output->GetCellData()->AddArray(MakeArray(
    "LargestError", GetLargestErrors(map, errors, vertexErrors, output->GetNumberOfCells())));
}

void lms3dFillScenePoints(const lms3dSceneErrors& errors, vtkPolyData* output)
{
  const std::size_t count = errors.Points.size();
  auto coordinates = lms3dMakeArray<vtkDoubleArray>("Points", count, 3);
  double* coordinate = coordinates->GetPointer(0);
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    coordinate = std::copy(errors.Points[i].begin(), errors.Points[i].end(), coordinate);
    const vtkIdType point = static_cast<vtkIdType>(i);
    vertices->InsertNextCell(1, &point);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetScalars(MakeArray("Error", errors.Distances));
}

void lms3dAddResults(const lms3dComparisonResults& results, vtkFieldData* output)
{
  Add("MapTriangles", static_cast<double>(results.MapTriangles), output);
  Add("MapArea", results.MapArea, output);
  Add("VisibleArea", results.VisibleArea, output);
  Add("AreaInFreeSpace", results.AreaInFreeSpace, output);
  Add("ClosedGapAreaInFreeSpace", results.ClosedGapAreaInFreeSpace, output);

  Add("MapToScene", results.MapToScene, output);
  Add("SceneToMap", results.SceneToMap, output);
  Add("NormalError", results.NormalError, output);

  Add("Correctness", results.Correctness, output);
  Add("Completeness", results.Completeness, output);
  Add("FScore", results.FScore, output);

  if (!std::isnan(results.ReturnsWithinTolerance))
  {
    Add("ReturnsWithinTolerance", results.ReturnsWithinTolerance, output);
    Add("LargestReturnDistance", results.LargestReturnDistance, output);
  }
}
