// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionMesher.h"

#include "Fusion/lms3dCreaseSnapping.h"
#include "Fusion/lms3dOutlineSimplifier.h"
#include "Fusion/lms3dRasterRows.h"
#include "Fusion/lms3dRegionRaster.h"
#include "Triangulation/lms3dTriangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace
{
// As a share of the bound: how far the border of a region may move when it is straightened.
constexpr double BorderShare = 3.0;
// Cells: the largest distance from a point of a cell to the centre of one of its eight neighbours.
constexpr double NeighbourDistance = 2.1213203435596424;
// Cells: the circumradius of a facet.
constexpr double FacetRadius = 0.25;

using Corners2 = std::array<lms3dPoint2, 3>;

/// The triangles of outlines.
std::optional<std::vector<Corners2>> Triangulate(const std::vector<lms3dLoop>& loops)
{
  std::vector<lms3dPoint2> points;
  std::map<lms3dPoint2, std::int32_t> numbers;
  std::vector<std::int32_t> corners;
  std::vector<std::int32_t> ends;
  for (const lms3dLoop& loop : loops)
  {
    if (loop.size() < 3)
    {
      continue;
    }
    for (const lms3dPoint2& point : loop)
    {
      const auto [place, isNew] =
        numbers.try_emplace(point, static_cast<std::int32_t>(points.size()));
      if (isNew)
      {
        points.push_back(point);
      }
      corners.push_back(place->second);
    }
    ends.push_back(static_cast<std::int32_t>(corners.size()));
  }
  std::vector<Corners2> triangles;
  if (points.empty())
  {
    return triangles;
  }
  const lms3dTriangulation triangulation(points, corners, ends);
  if (!triangulation.IsValid())
  {
    return {};
  }
  for (int i = 0; i < triangulation.GetNumberOfTriangles(); ++i)
  {
    if (triangulation.IsInside(i))
    {
      const std::array<std::int32_t, 3>& ids = triangulation.GetCorners(i);
      triangles.push_back({ points[ids[0]], points[ids[1]], points[ids[2]] });
    }
  }
  return triangles;
}

/// Makes the mesh of one plane.
class Mesher
{
public:
  Mesher(lms3dFusedPlane& plane, const std::vector<lms3dCreaseLine>& creases, double maximumError)
    : Plane(plane)
    , Creases(creases)
    , MaximumError(maximumError)
    , Region(lms3dMakeRegion(plane.Raster))
  {
  }

  void Make()
  {
    this->Plane.Mesh.Clear();
    for (int i = 0; i < this->Plane.Raster.GetNumberOfBlocks(); ++i)
    {
      this->Plane.Raster.GetBlock(i).Covered = {};
      this->Plane.Raster.GetBlock(i).Touched = {};
    }
    if (!this->Plane.Verbatim.empty() && this->IsWhole())
    {
      this->AddVerbatim();
      return;
    }
    for (const Corners2& triangle : this->FindTriangles())
    {
      this->Cover(triangle);
      this->Touch(triangle);
      this->Add(triangle);
    }
    this->AddFacets();
  }

private:
  /// Whether no beam passed through the triangle of a local map.
  bool IsWhole() const
  {
    for (int i = 0; i < this->Region.GetNumberOfBlocks(); ++i)
    {
      const lms3dBits& may = this->Plane.Raster.GetBlock(i).May;
      const lms3dBits& region = this->Region.GetBlock(i).May;
      for (int row = 0; row < lms3dRaster::Size; ++row)
      {
        if ((may[row] & ~region[row]) != 0)
        {
          return false;
        }
      }
    }
    return true;
  }

  void AddVerbatim()
  {
    for (const std::array<lms3dVector, 3>& corners : this->Plane.Verbatim)
    {
      const auto first = static_cast<std::int32_t>(this->Plane.Mesh.Points.size());
      Corners2 cells;
      for (int i = 0; i < 3; ++i)
      {
        this->Plane.Mesh.Points.push_back(corners[i]);
        cells[i] = this->Plane.Frame.ToCells(corners[i]);
      }
      this->Cover(cells);
      this->Touch(cells);
      this->Plane.Mesh.Triangles.push_back({ first, first + 1, first + 2 });
    }
  }

  /// Straightens the borders as far as triangles can be made of them.
  std::vector<Corners2> FindTriangles()
  {
    const std::vector<lms3dLoop> outlines = lms3dTraceOutlines(this->Region);
    const double tolerance = BorderShare * this->MaximumError / this->Plane.Frame.GetCell();
    std::vector<bool> isFixed;
    const std::vector<lms3dLoop> snapped =
      lms3dSnapToCreases(outlines, this->Creases, this->Region, isFixed);
    lms3dOutlineSimplifier simplifier(this->Region, snapped, isFixed, tolerance);
    std::optional<std::vector<Corners2>> triangles = Triangulate(simplifier.Simplify());
    if (!triangles)
    {
      std::size_t corners = 0;
      for (const lms3dLoop& loop : outlines)
      {
        corners += loop.size();
      }
      isFixed.assign(corners, false);
      lms3dOutlineSimplifier plain(this->Region, outlines, isFixed, tolerance);
      triangles = Triangulate(plain.Simplify());
    }
    if (!triangles)
    {
      triangles = Triangulate(outlines);
    }
    return triangles ? this->DropIslands(*triangles) : std::vector<Corners2>();
  }

  /// Drops connected triangles without a return on any of them.
  std::vector<Corners2> DropIslands(const std::vector<Corners2>& triangles) const
  {
    std::vector<std::size_t> group(triangles.size());
    std::iota(group.begin(), group.end(), std::size_t{ 0 });
    const auto find = [&group](std::size_t i)
    {
      while (group[i] != i)
      {
        group[i] = group[group[i]];
        i = group[i];
      }
      return i;
    };
    std::map<std::pair<lms3dPoint2, lms3dPoint2>, std::size_t> edges;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto [place, isNew] =
          edges.try_emplace(std::minmax(triangles[i][corner], triangles[i][(corner + 1) % 3]), i);
        group[find(i)] = find(place->second);
      }
    }
    std::vector<bool> hasReturn(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      if (!hasReturn[find(i)])
      {
        hasReturn[find(i)] = !lms3dForCentreRows(triangles[i],
          [&](std::int32_t row, std::int32_t first, std::int32_t last)
          { return !this->Plane.Raster.HasAny(&lms3dRasterBlock::Must, row, first, last); });
      }
    }
    std::vector<Corners2> kept;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      if (hasReturn[find(i)])
      {
        kept.push_back(triangles[i]);
      }
    }
    return kept;
  }

  void Touch(const Corners2& triangle)
  {
    lms3dForTouchedRows(triangle,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      {
        this->Plane.Raster.SetRow(
          &lms3dRasterBlock::Touched, row, first, last, true, false, [](int) {});
        return true;
      });
  }

  void Cover(const Corners2& triangle)
  {
    lms3dForCentreRows(triangle,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      {
        this->Plane.Raster.SetRow(
          &lms3dRasterBlock::Covered, row, first, last, true, false, [](int) {});
        return true;
      });
  }

  void Add(const Corners2& triangle)
  {
    lms3dFusedMesh::Triangle corners;
    for (int i = 0; i < 3; ++i)
    {
      const auto [place, isNew] = this->Numbers.try_emplace(
        triangle[i], static_cast<std::int32_t>(this->Plane.Mesh.Points.size()));
      if (isNew)
      {
        this->Plane.Mesh.Points.push_back(this->Plane.Frame.ToWorld(triangle[i]));
      }
      corners[i] = place->second;
    }
    this->Plane.Mesh.Triangles.push_back(corners);
  }

  bool IsCovered(std::int32_t u, std::int32_t v, int reach) const
  {
    for (std::int32_t row = v - reach; row <= v + reach; ++row)
    {
      if (this->Plane.Raster.HasAny(&lms3dRasterBlock::Covered, row, u - reach, u + reach))
      {
        return true;
      }
    }
    return false;
  }

  /// Adds facets at returns that the triangles do not explain.
  void AddFacets()
  {
    for (int i = 0; i < this->Region.GetNumberOfBlocks(); ++i)
    {
      const lms3dRasterBlock& block = this->Plane.Raster.GetBlock(i);
      const int reach =
        lms3dGetCoveredReach(block.Deviation, this->Plane.Frame.GetCell(), this->MaximumError);
      for (int row = 0; row < lms3dRaster::Size; ++row)
      {
        const std::uint64_t open = block.Must[row] & ~block.Covered[row];
        for (int place = 0; place < lms3dRaster::Size && open >> place != 0; ++place)
        {
          const std::int32_t u = block.U * lms3dRaster::Size + place;
          const std::int32_t v = block.V * lms3dRaster::Size + row;
          if ((open >> place & 1U) != 0 && !this->IsCovered(u, v, reach))
          {
            this->AddFacet({ u + 0.5, v + 0.5 });
          }
        }
      }
    }
  }

  void AddFacet(const lms3dPoint2& centre)
  {
    const double half = FacetRadius * std::sqrt(0.75);
    this->Add({ { { centre[0] - half, centre[1] - FacetRadius / 2.0 },
      { centre[0] + half, centre[1] - FacetRadius / 2.0 },
      { centre[0], centre[1] + FacetRadius } } });
    // A facet explains its neighbours as well.
    this->Cover({ { { centre[0] - 0.1, centre[1] - 0.1 }, { centre[0] + 0.1, centre[1] - 0.1 },
      { centre[0], centre[1] + 0.2 } } });
  }

  lms3dFusedPlane& Plane;
  const std::vector<lms3dCreaseLine>& Creases;
  const double MaximumError;
  const lms3dRaster Region;
  std::map<lms3dPoint2, std::int32_t> Numbers;
};

/// The sightings of the block around a point, or of the nearest block if no return lies in this one.
lms3dSightings GetSightings(const lms3dRaster& raster, const lms3dPoint2& point)
{
  const int number = raster.Find(lms3dRaster::GetBlockOf(static_cast<std::int32_t>(point[0])),
    lms3dRaster::GetBlockOf(static_cast<std::int32_t>(point[1])));
  if (number >= 0 && raster.GetBlock(number).Sightings.ScanCount > 0)
  {
    return raster.GetBlock(number).Sightings;
  }
  const double u = point[0] / lms3dRaster::Size - 0.5;
  const double v = point[1] / lms3dRaster::Size - 0.5;
  const lms3dRasterBlock* best = nullptr;
  double least = 0.0;
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    const double distance = (block.U - u) * (block.U - u) + (block.V - v) * (block.V - v);
    if (block.Sightings.ScanCount > 0 && (!best || distance < least))
    {
      best = &block;
      least = distance;
    }
  }
  return best ? best->Sightings : lms3dSightings();
}
} // namespace

int lms3dGetCoveredReach(double deviation, double cell, double maximumError)
{
  return std::hypot(deviation, NeighbourDistance * cell) <= maximumError ? 1 : 0;
}

void lms3dSetSightings(lms3dFusedPlane& plane)
{
  lms3dFusedMesh& mesh = plane.Mesh;
  mesh.Sightings.clear();
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const lms3dVector centre =
      lms3dScale(lms3dAdd(mesh.Points[a], lms3dAdd(mesh.Points[b], mesh.Points[c])), 1.0 / 3.0);
    mesh.Sightings.push_back(GetSightings(plane.Raster, plane.Frame.ToCells(centre)));
  }
}

void lms3dMakeRegionMesh(
  lms3dFusedPlane& plane, const std::vector<lms3dCreaseLine>& creases, double maximumError)
{
  Mesher(plane, creases, maximumError).Make();
}
