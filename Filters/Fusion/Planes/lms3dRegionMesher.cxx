// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dRegionMesher.h"

#include "Fusion/Cells/lms3dCoveredCells.h"
#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Cells/lms3dRegionRaster.h"
#include "Fusion/Outlines/lms3dIslands.h"
#include "Fusion/Outlines/lms3dMeshedBlock.h"
#include "Fusion/Outlines/lms3dPinholes.h"
#include "Fusion/Outlines/lms3dRegionCover.h"
#include "Fusion/Outlines/lms3dRegionTriangles.h"
#include "Fusion/Outlines/lms3dSmallHoles.h"
#include "Fusion/Outlines/lms3dTileSides.h"
#include "Fusion/Planes/lms3dFacet.h"

#include <algorithm>
#include <map>

namespace
{
// As a share of the bound: how far the border of a region may move when it is straightened.
constexpr double BorderShare = 6.0;
// Cells: how far a border may stay away from the centre of a cell with a return, which may lie
// anywhere in the cell. The farther, the more beams of returns that are cut off miss the map.
// Borders move outwards in the end, so few returns stay cut off.
constexpr double ReachOfBorder = 1.2;
constexpr double HalfDiagonal = 0.70710678118654752;
static_assert(ReachOfBorder + HalfDiagonal < lms3dNearCoveredDistance,
  "A return that is cut off must be within the bound of the border");

/// Makes the mesh of one tile.
class Mesher
{
public:
  Mesher(lms3dFusedPlane& plane, lms3dFusedTile& tile, const std::vector<lms3dCreaseLine>& creases,
    double maximumError)
    : Plane(plane)
    , Tile(tile)
    , Creases(creases)
    , MaximumError(maximumError)
    , Region(lms3dCopySureReturns(plane.Raster, tile.Blocks))
  {
    for (std::size_t i = 0; i < tile.Blocks.size(); ++i)
    {
      const lms3dRasterBlock& block = plane.Raster.GetBlock(tile.Blocks[i]);
      this->Region.GetBlock(static_cast<int>(i)).May =
        block.IsShapeFull ? lms3dAllBits : block.Shape;
    }
    if (plane.Verbatim.empty())
    {
      lms3dOpenPinholes(tile, this->Region);
      lms3dCloseGapsAlongSides(tile, this->Region);
    }
  }

  void Make()
  {
    this->Tile.Mesh.Clear();
    this->Tile.Facets.clear();
    if (!this->Plane.Verbatim.empty() && this->IsWhole())
    {
      this->AddVerbatim();
      this->AddFacets(false);
    }
    else
    {
      this->AddRegion();
      this->AddFacets(true);
    }
    for (std::size_t i = 0; i < this->Tile.Blocks.size(); ++i)
    {
      lms3dNoteMesh(this->Region.GetBlock(static_cast<int>(i)),
        this->Plane.Raster.GetBlock(this->Tile.Blocks[i]));
    }
  }

private:
  /// Whether no beam passed through the triangle of a local map, or through a facet. Facets have no
  /// May.
  bool IsWhole() const
  {
    bool isSeen = false;
    for (const int number : this->Tile.Blocks)
    {
      const lms3dRasterBlock& block = this->Plane.Raster.GetBlock(number);
      for (int row = 0; row < lms3dRaster::Size; ++row)
      {
        if ((block.May[row] & ~block.Shape[row]) != 0)
        {
          return false;
        }
        isSeen = isSeen || (block.May[row] | block.Must[row]) != 0;
      }
    }
    return isSeen;
  }

  void AddRegion()
  {
    std::vector<lms3dLoop> outlines = lms3dTraceOutlines(this->Region);
    if (this->Plane.Verbatim.empty())
    {
      lms3dCloseSmallHoles(this->Plane.Raster, outlines, this->Region);
    }
    if (this->Plane.Verbatim.empty() && this->Plane.IsWeak &&
      lms3dJoinIslands(outlines, this->Plane.Raster, this->Creases, this->Region))
    {
      outlines = lms3dTraceOutlines(this->Region);
    }
    lms3dAddBlocksAround(this->Tile, this->Region);
    const std::vector<lms3dTriangle2> triangles =
      lms3dTriangulateRegion(outlines, this->Region, this->Creases, this->Tile,
        BorderShare * this->MaximumError / this->Plane.Frame.GetCell(), ReachOfBorder);
    lms3dCoverRegion(triangles, this->Region);
    for (const lms3dTriangle2& triangle : triangles)
    {
      this->Add(triangle);
    }
  }

  void AddVerbatim()
  {
    for (const std::array<lms3dVector, 3>& corners : this->Plane.Verbatim)
    {
      const auto first = static_cast<std::int32_t>(this->Tile.Mesh.Points.size());
      lms3dTriangle2 cells;
      for (int i = 0; i < 3; ++i)
      {
        this->Tile.Mesh.Points.push_back(corners[i]);
        cells[i] = this->Plane.Frame.ToCells(corners[i]);
      }
      this->Cover(cells);
      this->Touch(cells);
      this->Tile.Mesh.Triangles.push_back({ first, first + 1, first + 2 });
    }
  }

  void Touch(const lms3dTriangle2& triangle)
  {
    lms3dForTouchedStrips(triangle,
      [&](const lms3dCellStrip& strip)
      {
        this->Region.Set(&lms3dRasterBlock::Touched, strip, true);
        return true;
      });
  }

  void Cover(const lms3dTriangle2& triangle)
  {
    lms3dForCentreStrips(triangle,
      [&](const lms3dCellStrip& strip)
      {
        this->Region.Set(&lms3dRasterBlock::Covered, strip, true);
        return true;
      });
  }

  void Add(const lms3dTriangle2& triangle)
  {
    lms3dFusedMesh::Triangle corners;
    for (int i = 0; i < 3; ++i)
    {
      const auto [place, isNew] = this->Numbers.try_emplace(
        triangle[i], static_cast<std::int32_t>(this->Tile.Mesh.Points.size()));
      if (isNew)
      {
        this->Tile.Mesh.Points.push_back(this->Plane.Frame.ToWorld(triangle[i]));
      }
      corners[i] = place->second;
    }
    this->Tile.Mesh.Triangles.push_back(corners);
  }

  /// Adds facets at returns that the triangles do not explain. The triangle of a local map explains
  /// its own returns, even where it covers the centre of no cell.
  void AddFacets(bool addsToOwn)
  {
    for (std::size_t i = 0; i < this->Tile.Blocks.size(); ++i)
    {
      const lms3dRasterBlock& block = this->Plane.Raster.GetBlock(this->Tile.Blocks[i]);
      const lms3dBits& covered = this->Region.GetBlock(static_cast<int>(i)).Covered;
      if (lms3dAreAllSet(covered))
      {
        continue;
      }
      for (int row = 0; row < lms3dRaster::Size; ++row)
      {
        const std::uint64_t own = addsToOwn ? block.Must[row] : 0;
        std::uint64_t open = (own | block.Beside[row]) & ~covered[row];
        for (; open != 0; open &= open - 1)
        {
          const int place = lms3dGetFirstBit(open);
          const std::int32_t u = block.U * lms3dRaster::Size + place;
          const std::int32_t v = block.V * lms3dRaster::Size + row;
          if (!lms3dIsCovered(
                this->Region, this->Tile.GetCells(), u, v, block.GetCoveredReach(row, place)))
          {
            this->AddFacet({ u + 0.5, v + 0.5 });
            this->Tile.Facets.push_back({ u, v });
          }
        }
      }
    }
  }

  void AddFacet(const lms3dPoint2& centre)
  {
    this->Add(lms3dMakeFacet(centre));
    // A facet explains its neighbours as well.
    this->Cover({ { { centre[0] - 0.1, centre[1] - 0.1 }, { centre[0] + 0.1, centre[1] - 0.1 },
      { centre[0], centre[1] + 0.2 } } });
  }

  lms3dFusedPlane& Plane;
  lms3dFusedTile& Tile;
  const std::vector<lms3dCreaseLine>& Creases;
  const double MaximumError;
  /// The blocks of the tile first, in its order.
  lms3dRegion Region;
  std::map<lms3dPoint2, std::int32_t> Numbers;
};
} // namespace

void lms3dMakeTileMesh(lms3dFusedPlane& plane, lms3dFusedTile& tile,
  const std::vector<lms3dCreaseLine>& creases, double maximumError)
{
  Mesher(plane, tile, creases, maximumError).Make();
}
