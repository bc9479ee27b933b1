// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedOutput.h"

#include "Geometry/lms3dTriangleDistance.h"
#include "LocalMap/Grid/lms3dMapScan.h"
#include "Pipeline/lms3dArray.h"

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

namespace
{
// Applies the rotation of a row-major 4 x 4 matrix.
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
  const auto coordinates = lms3dMakeArray<vtkDoubleArray>("Points", bounded.Points.size(), 3);
  const auto ranges = lms3dMakeArray<vtkDoubleArray>("Range", bounded.Points.size());
  double* out = coordinates->GetPointer(0);
  double* range = ranges->GetPointer(0);
  for (const lms3dVector& point : bounded.Points)
  {
    const lms3dVector rotated = Rotate(matrix, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      *out++ = rotated[axis] + matrix[4 * axis + 3];
    }
    *range++ = lms3dGetLength(point);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  map->SetPoints(points);
  map->GetPointData()->SetScalars(ranges);
}

void FillTriangles(const lms3dBoundedMap& bounded, vtkPolyData* map)
{
  const std::size_t count = bounded.Triangles.size();
  const auto connectivity = lms3dMakeArray<vtkIdTypeArray>("Connectivity", 3 * count);
  const auto offsets = lms3dMakeArray<vtkIdTypeArray>("Offsets", count + 1);
  const auto patches = lms3dMakeArray<vtkIntArray>("PatchId", count);
  vtkIdType* corner = connectivity->GetPointer(0);
  lms3dFillOffsets(offsets->GetPointer(0), count, 3);
  for (const std::array<std::int32_t, 3>& triangle : bounded.Triangles)
  {
    corner = std::copy(triangle.begin(), triangle.end(), corner);
  }
  std::copy(bounded.PatchIds.begin(), bounded.PatchIds.end(), patches->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  map->SetPolys(polygons);
  map->GetCellData()->AddArray(patches);
}

// Fills the normals of triangles. Normals of points would blur the shading of large triangles
// across creases.
void FillNormals(const lms3dBoundedMap& bounded, const double* matrix, vtkPolyData* map)
{
  const auto normals = lms3dMakeArray<vtkFloatArray>("Normals", bounded.Triangles.size(), 3);
  float* out = normals->GetPointer(0);
  for (const auto& [a, b, c] : bounded.Triangles)
  {
    const lms3dVector normal = Rotate(matrix,
      lms3dGetWeightedNormal(
        { bounded.Points[a].data(), bounded.Points[b].data(), bounded.Points[c].data() }));
    const double length = lms3dGetLength(normal);
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
  const auto array = lms3dMakeArray<ArrayT>(name, 1);
  array->SetValue(0, value);
  lms3dAddHiddenArray(array, map->GetFieldData());
}
} // namespace

void lms3dFillBoundedOutput(
  const lms3dMapScan& scan, const lms3dBoundedMap& bounded, vtkPolyData* map)
{
  const double* matrix = scan.GetMapToWorld();
  FillPoints(bounded, matrix, map);
  FillTriangles(bounded, map);
  FillNormals(bounded, matrix, map);
  AddField<vtkIntArray>(map, "NumberOfPatches", bounded.NumberOfPatches);
  AddField<vtkIdTypeArray>(
    map, "NumberOfReturns", scan.GetNumberOfReturns() + scan.GetNumberOfRepeatedReturns());
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnPatches", bounded.ReturnsOnPatches);
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnFacets", bounded.ReturnsOnFacets);
  AddField<vtkIdTypeArray>(map, "NumberOfReturnsOnGrid", bounded.ReturnsOnGrid);
  if (scan.GetNumberOfRepeatedReturns() > 0)
  {
    AddField<vtkIdTypeArray>(
      map, "NumberOfReturnsOnRepeatedTurns", scan.GetNumberOfRepeatedReturns());
  }
  AddField<vtkDoubleArray>(map, "LargestDeviation", bounded.LargestDeviation);
}
