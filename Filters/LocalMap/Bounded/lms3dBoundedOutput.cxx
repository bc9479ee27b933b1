// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedOutput.h"

#include "Device/lms3dScanInput.h"
#include "Geometry/lms3dTriangleDistance.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace
{
template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeArray(const char* name, std::size_t count, int components = 1)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

// The upper left of a matrix of four columns times a vector.
lms3dVector Rotate(const double* matrix, const lms3dVector& v)
{
  lms3dVector rotated;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* row = matrix + 4 * axis;
    rotated[axis] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
  }
  return rotated;
}

void FillPoints(const lms3dBoundedMap& bounded, const double* matrix, vtkPolyData* map)
{
  const auto coordinates = MakeArray<vtkDoubleArray>("Points", bounded.Points.size(), 3);
  const auto ranges = MakeArray<vtkDoubleArray>("Range", bounded.Points.size());
  double* out = coordinates->GetPointer(0);
  double* range = ranges->GetPointer(0);
  for (const lms3dVector& point : bounded.Points)
  {
    const lms3dVector rotated = Rotate(matrix, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      *out++ = rotated[axis] + matrix[4 * axis + 3];
    }
    *range++ = std::sqrt(lms3dDot(point, point));
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  map->SetPoints(points);
  map->GetPointData()->SetScalars(ranges);
}

void FillTriangles(const lms3dBoundedMap& bounded, vtkPolyData* map)
{
  const std::size_t count = bounded.Triangles.size();
  const auto connectivity = MakeArray<vtkIdTypeArray>("Connectivity", 3 * count);
  const auto offsets = MakeArray<vtkIdTypeArray>("Offsets", count + 1);
  const auto patches = MakeArray<vtkIntArray>("PatchId", count);
  vtkIdType* corner = connectivity->GetPointer(0);
  vtkIdType* offset = offsets->GetPointer(0);
  *offset = 0;
  for (const std::array<std::int32_t, 3>& triangle : bounded.Triangles)
  {
    corner = std::copy(triangle.begin(), triangle.end(), corner);
    offset[1] = offset[0] + 3;
    ++offset;
  }
  std::copy(bounded.PatchIds.begin(), bounded.PatchIds.end(), patches->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  map->SetPolys(polygons);
  map->GetCellData()->AddArray(patches);
}

// Of the triangles: those of points would smear the shading of large triangles across creases.
void FillNormals(const lms3dBoundedMap& bounded, const double* matrix, vtkPolyData* map)
{
  const auto normals = MakeArray<vtkFloatArray>("Normals", bounded.Triangles.size(), 3);
  float* out = normals->GetPointer(0);
  for (const auto& [a, b, c] : bounded.Triangles)
  {
    const lms3dVector normal = Rotate(matrix,
      lms3dGetWeightedNormal(
        { bounded.Points[a].data(), bounded.Points[b].data(), bounded.Points[c].data() }));
    const double length = std::sqrt(lms3dDot(normal, normal));
    for (double component : normal)
    {
      *out++ = static_cast<float>(component / length);
    }
  }
  map->GetCellData()->SetNormals(normals);
}

template <typename ArrayT, typename T>
void AddField(vtkPolyData* map, const char* name, T value)
{
  const auto array = MakeArray<ArrayT>(name, 1);
  array->SetValue(0, value);
  map->GetFieldData()->AddArray(array);
}
} // namespace

void lms3dFillBoundedOutput(
  const lms3dScanInput& scan, const lms3dBoundedMap& bounded, vtkPolyData* map)
{
  const double* matrix = scan.GetSensorToWorld();
  FillPoints(bounded, matrix, map);
  FillTriangles(bounded, map);
  FillNormals(bounded, matrix, map);
  AddField<vtkIntArray>(map, "NumberOfPatches", bounded.NumberOfPatches);
  AddField<vtkIdTypeArray>(map, "NumberOfReturns", scan.GetNumberOfReturns());
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnPatches", bounded.ReturnsOnPatches);
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnFacets", bounded.ReturnsOnFacets);
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnGrid", bounded.ReturnsOnGrid);
  AddField<vtkDoubleArray>(map, "LargestDeviation", bounded.LargestDeviation);
}
