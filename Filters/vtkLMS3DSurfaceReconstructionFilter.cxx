// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include "lms3dAlgorithmProgress.h"
#include "lms3dGridMesher.h"
#include "lms3dRangeGrid.h"
#include "lms3dScanInput.h"

#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

vtkStandardNewMacro(vtkLMS3DSurfaceReconstructionFilter);

namespace
{
using Triangle = lms3dGridMesher::Triangle;

void AddPoints(const lms3dScanInput& scan, const lms3dRangeGrid& grid, vtkPolyData* map)
{
  const vtkIdType count = static_cast<vtkIdType>(grid.GetReturns().size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> range;
  range->SetName("Range");
  range->SetNumberOfValues(count);
  double* out = coordinates->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::int64_t source = grid.GetReturns()[i];
    out = std::copy_n(scan.GetPoints() + 3 * source, 3, out);
    range->SetValue(i, scan.GetRanges()[source]);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  map->SetPoints(points);
  map->GetPointData()->SetScalars(range);
}

void AddTriangles(const std::vector<Triangle>& triangles, vtkPolyData* map)
{
  const vtkIdType count = static_cast<vtkIdType>(triangles.size());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  vtkIdType* corner = connectivity->GetPointer(0);
  for (const Triangle& triangle : triangles)
  {
    corner = std::copy(triangle.begin(), triangle.end(), corner);
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  map->SetPolys(polygons);
}

// A triangle's normal, as long as twice its area, so that large triangles weigh more.
std::array<double, 3> GetWeightedNormal(const double* a, const double* b, const double* c)
{
  const double p[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double q[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  return { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] };
}

std::vector<double> SumNormals(const std::vector<Triangle>& triangles, vtkPolyData* map)
{
  const double* points = vtkDoubleArray::FastDownCast(map->GetPoints()->GetData())->GetPointer(0);
  std::vector<double> sums(3 * map->GetNumberOfPoints(), 0.0);
  for (const Triangle& triangle : triangles)
  {
    const std::array<double, 3> normal = GetWeightedNormal(
      points + 3 * triangle[0], points + 3 * triangle[1], points + 3 * triangle[2]);
    for (std::int64_t corner : triangle)
    {
      for (int i = 0; i < 3; ++i)
      {
        sums[3 * corner + i] += normal[i];
      }
    }
  }
  return sums;
}

void AddNormals(
  const std::vector<Triangle>& triangles, const std::array<double, 3>& sensor, vtkPolyData* map)
{
  const std::vector<double> sums = SumNormals(triangles, map);
  const double* point = vtkDoubleArray::FastDownCast(map->GetPoints()->GetData())->GetPointer(0);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(map->GetNumberOfPoints());
  float* out = normals->GetPointer(0);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i, point += 3)
  {
    std::array<double, 3> normal = { sums[3 * i], sums[3 * i + 1], sums[3 * i + 2] };
    if (std::hypot(normal[0], normal[1], normal[2]) == 0.0)
    {
      normal = { sensor[0] - point[0], sensor[1] - point[1], sensor[2] - point[2] };
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double component : normal)
    {
      *out++ = static_cast<float>(component / length);
    }
  }
  map->GetPointData()->SetNormals(normals);
}
} // namespace

int vtkLMS3DSurfaceReconstructionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  const lms3dProgress goesOn = lms3dReportTo(this, 0.0, 1.0);
  try
  {
    if (std::isnan(this->DepthStep))
    {
      throw std::runtime_error("DepthStep is not a number; 0 or more metres are expected.");
    }
    const lms3dScanInput scan(vtkPolyData::GetData(inputVector[0]));
    if (scan.GetNumberOfReturns() == 0)
    {
      return 1;
    }
    const lms3dRangeGrid grid(
      scan.GetGeometry(), scan.GetRanges(), scan.GetBeamIds(), scan.GetNumberOfReturns());
    if (!goesOn(0.3))
    {
      return 1;
    }
    const lms3dGridMesher mesher(grid, scan.GetPoints(), this->DepthStep);
    const std::vector<Triangle> triangles = mesher.MakeTriangles();
    if (!goesOn(0.6))
    {
      return 1;
    }
    vtkPolyData* map = vtkPolyData::GetData(outputVector);
    AddPoints(scan, grid, map);
    AddTriangles(triangles, map);
    AddNormals(triangles, scan.GetSensorPosition(), map);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  return 1;
}

void vtkLMS3DSurfaceReconstructionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthStep: " << this->DepthStep << '\n';
}
