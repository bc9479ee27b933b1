// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridMap.h"

#include "lms3dGridNormals.h"
#include "lms3dPooledArray.h"
#include "lms3dScanInput.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace
{
void CopyReturns(
  const lms3dScanInput& scan, const lms3dRangeGrid& grid, double* points, double* ranges)
{
  const std::vector<std::int32_t>& returns = grid.GetReturns();
  const double* scanPoints = scan.GetPoints();
  const double* scanRanges = scan.GetRanges();
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, static_cast<vtkIdType>(returns.size()), 4096),
    [&](const tbb::blocked_range<vtkIdType>& vertices)
    {
      for (vtkIdType i = vertices.begin(); i < vertices.end(); ++i)
      {
        const vtkIdType source = returns[i];
        points[3 * i] = scanPoints[3 * source];
        points[3 * i + 1] = scanPoints[3 * source + 1];
        points[3 * i + 2] = scanPoints[3 * source + 2];
        ranges[i] = scanRanges[source];
      }
    });
}

void FillOffsets(vtkIdType triangles, vtkIdType* offsets)
{
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, triangles + 1, 4096),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType i = range.begin(); i < range.end(); ++i)
      {
        offsets[i] = 3 * i;
      }
    });
}
} // namespace

void lms3dGridMap::Fill(const lms3dScanInput& scan, const lms3dRangeGrid& grid,
  const lms3dRangeJoins& joins, const lms3dProgress& progress, vtkPolyData* map)
{
  const vtkIdType vertices = static_cast<vtkIdType>(grid.GetReturns().size());
  const auto coordinates = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Points", vertices, 3);
  const auto ranges = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Range", vertices);
  const double* points = coordinates->GetPointer(0);
  CopyReturns(scan, grid, coordinates->GetPointer(0), ranges->GetPointer(0));
  this->Mesher.ChooseTriangles(grid, joins, points);
  if (!progress(0.4))
  {
    return;
  }
  const vtkIdType triangles = this->Mesher.GetNumberOfTriangles();
  const auto connectivity =
    lms3dMakeArray<vtkIdTypeArray>(this->Pool, "Connectivity", 3 * triangles);
  const auto offsets = lms3dMakeArray<vtkIdTypeArray>(this->Pool, "Offsets", triangles + 1);
  this->Mesher.FillTriangles(grid, connectivity->GetPointer(0));
  FillOffsets(triangles, offsets->GetPointer(0));
  if (!progress(0.7))
  {
    return;
  }
  const auto normals = lms3dMakeArray<vtkFloatArray>(this->Pool, "Normals", vertices, 3);
  lms3dFillNormals(grid, this->Mesher, points, scan.GetSensorPosition(), normals->GetPointer(0));

  vtkNew<vtkPoints> mapPoints;
  mapPoints->SetData(coordinates);
  map->SetPoints(mapPoints);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  map->SetPolys(polygons);
  map->GetPointData()->SetScalars(ranges);
  map->GetPointData()->SetNormals(normals);
  this->Pool.FreeUnused();
}
