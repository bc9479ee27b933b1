// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dComparisonOutput.h"

#include "Comparison/lms3dErrorStatistics.h"

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
#include <limits>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void Add(const char* name, double value, vtkFieldData* results)
{
  results->AddArray(MakeArray(name, { value }));
}

void Add(const char* name, const lms3dErrorStatistics& errors, vtkFieldData* results)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(4);
  array->SetComponentName(0, "Mean");
  array->SetComponentName(1, "RMS");
  array->SetComponentName(2, "95 %");
  array->SetComponentName(3, "Maximum");
  array->InsertNextTuple4(errors.Mean, errors.RootMeanSquare, errors.Percentile95, errors.Maximum);
  results->AddArray(array);
}

double GetHarmonicMean(double a, double b)
{
  return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
}

// A cell's largest error is at least that of its vertices, since small cells have no sample.
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
  const vtkIdType count = static_cast<vtkIdType>(errors.Points.size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  double* coordinate = coordinates->GetPointer(0);
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    coordinate = std::copy(errors.Points[i].begin(), errors.Points[i].end(), coordinate);
    vertices->InsertNextCell(1, &i);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetScalars(MakeArray("Error", errors.Distances));
}

void lms3dAddResults(const lms3dTriangleMesh& map, const lms3dMapErrors& mapErrors,
  const lms3dTriangleMesh& scene, const lms3dSceneErrors& sceneErrors,
  const std::vector<double>& returnDistances, double tolerance, vtkFieldData* results)
{
  const double area = lms3dGetArea(map);
  Add("MapTriangles", static_cast<double>(map.GetNumberOfTriangles()), results);
  Add("MapArea", area, results);
  Add("VisibleArea", sceneErrors.VisibleShare * lms3dGetArea(scene), results);
  Add("AreaInFreeSpace", mapErrors.ShareInFreeSpace * area, results);

  Add("MapToScene", lms3dErrorStatistics(mapErrors.Distances), results);
  Add("SceneToMap", lms3dErrorStatistics(sceneErrors.Distances), results);
  Add("NormalError", lms3dErrorStatistics(mapErrors.Angles), results);

  const double correctness = lms3dGetShareWithin(mapErrors.Distances, tolerance);
  const double completeness = lms3dGetShareWithin(sceneErrors.Distances, tolerance);
  Add("Correctness", correctness, results);
  Add("Completeness", completeness, results);
  Add("FScore", GetHarmonicMean(correctness, completeness), results);

  if (!returnDistances.empty())
  {
    Add("ReturnsWithinTolerance", lms3dGetShareWithin(returnDistances, tolerance), results);
    Add("LargestReturnDistance", *std::max_element(returnDistances.begin(), returnDistances.end()),
      results);
  }
}
