// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dGridMap.h"

#include "LocalMap/Grid/lms3dGridNormals.h"
#include "LocalMap/Grid/lms3dMapScan.h"
#include "Pipeline/lms3dPooledArray.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
// With fewer triangles, starting another thread takes longer than the work.
constexpr int MinimumTrianglesPerTask = 4096;

/// Copies the returns to the points of the map and to the grid of points.
struct VertexArrays
{
  // All turns share the entry of a pole; its vertex belongs to the first turn.
  void FillTurn(const lms3dRangeGrid& grid, int turn, lms3dGridPoints& gridPoints) const
  {
    const std::int32_t* vertices = grid.GetVertices(turn);
    const std::int32_t* returns = grid.GetReturns().data();
    double* x = gridPoints.GetRow(0, turn);
    double* y = gridPoints.GetRow(1, turn);
    double* z = gridPoints.GetRow(2, turn);
    if (!grid.HasReturns(turn))
    {
      for (double* row : { x, y, z })
      {
        std::fill_n(row, grid.GetNumberOfBeams(), 0.0);
      }
      return;
    }
    for (int beam = 0; beam < grid.GetNumberOfBeams(); ++beam)
    {
      const vtkIdType vertex = vertices[beam];
      if (vertex == lms3dRangeGrid::NoVertex)
      {
        x[beam] = y[beam] = z[beam] = 0.0;
        continue;
      }
      const vtkIdType source = returns[vertex];
      const double* point = this->ScanPoints + 3 * source;
      x[beam] = point[0];
      y[beam] = point[1];
      z[beam] = point[2];
      if (vertex >= grid.GetFirstVertex(turn))
      {
        double* out = this->Points + 3 * vertex;
        out[0] = point[0];
        out[1] = point[1];
        out[2] = point[2];
        this->Ranges[vertex] = this->ScanRanges[source];
      }
    }
  }

  const double* ScanPoints;
  const double* ScanRanges;
  double* Points;
  double* Ranges;
};

// By several threads, unlike lms3dFillOffsets: the plain grid has up to two triangles for each
// beam.
void FillOffsets(int triangles, std::int32_t* offsets)
{
  tbb::parallel_for(tbb::blocked_range<int>(0, triangles + 1, MinimumTrianglesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int i = range.begin(); i < range.end(); ++i)
      {
        offsets[i] = 3 * i;
      }
    });
}

void ReverseTriangles(int triangles, std::int32_t* vertices)
{
  tbb::parallel_for(tbb::blocked_range<int>(0, triangles, MinimumTrianglesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int i = range.begin(); i < range.end(); ++i)
      {
        std::swap(vertices[3 * i + 1], vertices[3 * i + 2]);
      }
    });
}

// Cell arrays have 32 bits.
int CheckNumber(std::int64_t triangles)
{
  constexpr int Maximum = std::numeric_limits<std::int32_t>::max() / 3;
  if (triangles > Maximum)
  {
    throw std::runtime_error("The map would have " + std::to_string(triangles) +
      " triangles; at most " + std::to_string(Maximum) +
      " are possible. Choose lower resolutions.");
  }
  return static_cast<int>(triangles);
}
} // namespace

void lms3dGridMap::Fill(const lms3dMapScan& scan, const lms3dRangeGrid& grid,
  const lms3dRangeJoins& joins, const lms3dProgress& progress, vtkPolyData* map)
{
  const vtkIdType vertices = static_cast<vtkIdType>(grid.GetReturns().size());
  const auto coordinates = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Points", vertices, 3);
  const auto ranges = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Range", vertices);
  const VertexArrays out = { scan.GetPoints(), scan.GetDistances(), coordinates->GetPointer(0),
    ranges->GetPointer(0) };
  this->Points.SetShape(grid);
  tbb::parallel_for(
    0, grid.GetNumberOfTurns(), [&](int turn) { out.FillTurn(grid, turn, this->Points); });
  this->Points.FillHalo(grid);
  this->Mesher.SelectTriangles(grid, joins, this->Points);
  if (!progress(0.4))
  {
    return;
  }
  const vtkSmartPointer<vtkCellArray> triangles = this->MakeTriangles(grid);
  if (!progress(0.7))
  {
    return;
  }
  const auto normals = lms3dMakeArray<vtkFloatArray>(this->Pool, "Normals", vertices, 3);
  lms3dFillNormals(grid, this->Mesher, this->Points, scan.GetOrigin(), normals->GetPointer(0));

  vtkNew<vtkPoints> mapPoints;
  mapPoints->SetData(coordinates);
  map->SetPoints(mapPoints);
  map->SetPolys(triangles);
  map->GetPointData()->SetScalars(ranges);
  map->GetPointData()->SetNormals(normals);
  this->Pool.FreeUnused();
}

vtkSmartPointer<vtkCellArray> lms3dGridMap::MakeTriangles(const lms3dRangeGrid& grid)
{
  const int count = CheckNumber(this->Mesher.GetNumberOfTriangles());
  const auto connectivity = lms3dMakeArray<vtkTypeInt32Array>(
    this->Pool, "Connectivity", 3 * static_cast<vtkIdType>(count));
  const auto offsets =
    lms3dMakeArray<vtkTypeInt32Array>(this->Pool, "Offsets", static_cast<vtkIdType>(count) + 1);
  this->Mesher.FillTriangles(grid, connectivity->GetPointer(0));
  FillOffsets(count, offsets->GetPointer(0));
  if (grid.GetGeometry().IsMirrored())
  {
    ReverseTriangles(count, connectivity->GetPointer(0));
  }
  const auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(offsets, connectivity);
  return triangles;
}
