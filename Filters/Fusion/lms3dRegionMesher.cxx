// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionMesher.h"

#include "Fusion/lms3dCreaseCut.h"
#include "Fusion/lms3dCreaseSnapping.h"
#include "Fusion/lms3dOutlineSimplifier.h"
#include "Fusion/lms3dOutlineTriangles.h"
#include "Fusion/lms3dRasterRows.h"
#include "Fusion/lms3dRegionCover.h"
#include "Fusion/lms3dRegionRaster.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace
{
// As a share of the bound: how far the border of a region may move when it is straightened.
constexpr double BorderShare = 3.0;
// Cells: the largest distance from a point of a cell to the centre of one of its eight neighbours.
constexpr double NeighbourDistance = 2.1213203435596424;
// Cells: the circumradius of a facet.
constexpr double FacetRadius = 0.25;

using Corners2 = lms3dTriangle2;

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
    lms3dCutAtCreases(creases, this->Region);
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
    const std::vector<Corners2> triangles = this->FindTriangles();
    lms3dCoverRegion(triangles, this->Plane.Raster);
    for (const Corners2& triangle : triangles)
    {
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
    std::optional<std::vector<Corners2>> triangles =
      lms3dTriangulateOutlines(simplifier.Simplify());
    if (!triangles)
    {
      std::size_t corners = 0;
      for (const lms3dLoop& loop : outlines)
      {
        corners += loop.size();
      }
      isFixed.assign(corners, false);
      lms3dOutlineSimplifier plain(this->Region, outlines, isFixed, tolerance);
      triangles = lms3dTriangulateOutlines(plain.Simplify());
    }
    if (!triangles)
    {
      triangles = lms3dTriangulateOutlines(outlines);
    }
    return triangles ? lms3dDropIslands(*triangles, this->Plane.Raster) : std::vector<Corners2>();
  }

  void Touch(const Corners2& triangle)
  {
    lms3dForTouchedStrips(triangle,
      [&](const lms3dCellStrip& strip)
      {
        this->Plane.Raster.Set(&lms3dRasterBlock::Touched, strip, true);
        return true;
      });
  }

  void Cover(const Corners2& triangle)
  {
    lms3dForCentreStrips(triangle,
      [&](const lms3dCellStrip& strip)
      {
        this->Plane.Raster.Set(&lms3dRasterBlock::Covered, strip, true);
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
  lms3dRaster Region;
  std::map<lms3dPoint2, std::int32_t> Numbers;
};
} // namespace

int lms3dGetCoveredReach(double deviation, double cell, double maximumError)
{
  return std::hypot(deviation, NeighbourDistance * cell) <= maximumError ? 1 : 0;
}

void lms3dMakeRegionMesh(
  lms3dFusedPlane& plane, const std::vector<lms3dCreaseLine>& creases, double maximumError)
{
  Mesher(plane, creases, maximumError).Make();
}
