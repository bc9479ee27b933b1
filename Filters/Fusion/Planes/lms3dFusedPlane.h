// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A plane of a fused map, what scans know about it, and its triangles.
 */
#ifndef lms3dFusedPlane_h
#define lms3dFusedPlane_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Cells/lms3dRegionShape.h"
#include "Fusion/Outlines/lms3dFusedTile.h"
#include "Fusion/Planes/lms3dBlockGroups.h"
#include "Fusion/Planes/lms3dPlaneFrame.h"
#include "Fusion/Scans/lms3dLocalMap.h"
#include "Fusion/Scans/lms3dWorldBox.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

struct lms3dFusedPlane
{
  /// `memory` is that of the blocks, or nullptr.
  explicit lms3dFusedPlane(
    const lms3dPlaneFrame& frame, std::shared_ptr<lms3dBlockMemory> memory = nullptr)
    : Frame(frame)
    , Raster(std::move(memory))
  {
  }

  /// Returns whether a return lies within `bound`, metres, of the plane, and the plane is not
  /// nearer than the return by more, along the beam.
  bool Explains(const lms3dVector& point, const lms3dVector& direction, double bound) const
  {
    const double height = this->Frame.GetHeight(point);
    const double cosine = -lms3dDot(this->Frame.GetNormal(), direction);
    return height >= 0.0 ? height <= bound : -height <= bound * cosine;
  }

  /// The cells of the tile with a cell. A plane that is a triangle of a local map has one tile.
  lms3dCellBox GetCellsOfTile(std::int32_t u, std::int32_t v) const
  {
    return this->Verbatim.empty()
      ? lms3dFusedTile(lms3dFusedTile::GetTileOf(lms3dRaster::GetBlockOf(u)),
          lms3dFusedTile::GetTileOf(lms3dRaster::GetBlockOf(v)))
          .GetCells()
      : lms3dFusedTile().GetCells();
  }

  /// Whether the plane is a facet of lms3dFusedPlanes::AddFacet().
  bool IsFacet() const { return !this->Verbatim.empty() && !this->HasSurface; }

  /// Takes out all that scans saw. The tiles stay without blocks. They lose their triangles when
  /// they are made anew; tiles without blocks and triangles do not change.
  void Clear()
  {
    this->Raster.Clear();
    this->Shape = {};
    this->Returns = {};
    this->Verbatim.clear();
    this->IsWeak = false;
    this->HasGone = true;
    this->HasSurface = false;
    this->TileNumbers = {};
    this->UsedTiles = 0;
    this->TiledBlocks = 0;
    this->ShapedBlocks = 0;
    this->OldBlocks = 0;
    this->BoxOfBlocks = {};
    this->Groups = lms3dBlockGroups();
    this->BoxedBlocks = 0;
    this->HasNewCreases = true;
    for (lms3dFusedTile& tile : this->Tiles)
    {
      tile.IsStale = !tile.Blocks.empty() || !tile.Mesh.Triangles.empty();
      tile.Blocks.clear();
      tile.Difference = 0;
      tile.DifferenceAtCreases = 0;
    }
  }

  /// Makes another plane of one that was cleared and has no creases. It has the tiles, which must
  /// be up to date.
  void Reuse(const lms3dPlaneFrame& frame)
  {
    this->Frame = frame;
    this->IsCurved = false;
    this->HasGone = false;
    this->RegroupedTriangles = 0;
  }

  /// Drops the returns that later scans saw through.
  void DropForgotten()
  {
    if (!this->Raster.HasForgotten())
    {
      return;
    }
    const auto isForgotten = [this](const lms3dMappedReturn& mapped)
    {
      const lms3dPoint2 place = this->Frame.ToCells(mapped.Point);
      const auto u = lms3dGetCellOf(place[0]);
      const auto v = lms3dGetCellOf(place[1]);
      return !this->Raster.Has(&lms3dRasterBlock::Must, u, v) &&
        !this->Raster.Has(&lms3dRasterBlock::Beside, u, v);
    };
    this->Returns.erase(
      std::remove_if(this->Returns.begin(), this->Returns.end(), isForgotten), this->Returns.end());
  }

  std::size_t CountTriangles() const
  {
    std::size_t triangles = 0;
    for (const lms3dFusedTile& tile : this->Tiles)
    {
      triangles += tile.Mesh.Triangles.size();
    }
    return triangles;
  }

  lms3dWorldBox GetBoxOfBlock(int number) const
  {
    lms3dWorldBox box;
    const lms3dRasterBlock& block = this->Raster.GetBlock(number);
    for (const double u : { block.U + 0.0, block.U + 1.0 })
    {
      for (const double v : { block.V + 0.0, block.V + 1.0 })
      {
        box.Add(this->Frame.ToWorld({ u * lms3dRaster::Size, v * lms3dRaster::Size }));
      }
    }
    return box;
  }

  /// The box of the blocks from one on.
  lms3dWorldBox GetBoxOfBlocks(int first) const
  {
    lms3dWorldBox box;
    for (int number = first; number < this->Raster.GetNumberOfBlocks(); ++number)
    {
      box.Add(this->GetBoxOfBlock(number));
    }
    return box;
  }

  /// The box of all blocks.
  const lms3dWorldBox& GetBoxOfBlocks()
  {
    const lms3dWorldBox added = this->GetBoxOfBlocks(this->BoxedBlocks);
    this->BoxedBlocks = this->Raster.GetNumberOfBlocks();
    this->BoxOfBlocks.Add(added);
    return this->BoxOfBlocks;
  }

  /// The groups of all blocks.
  const lms3dBlockGroups& GetGroups()
  {
    this->Groups.Update(this->Raster);
    return this->Groups;
  }

  lms3dPlaneFrame Frame;
  lms3dRaster Raster;
  /// Whether the surface is curved.
  bool IsCurved = false;
  /// Whether few returns support the plane, so that a better view may take its place. Its returns
  /// are then kept.
  bool IsWeak = false;
  /// The returns of a weak plane, with the ones that lms3dFusedPlanes::AddBeside() added.
  std::vector<lms3dMappedReturn> Returns;
  /// How many triangles the plane had when it last began a place of lms3dRegrouping, or was new.
  std::size_t RegroupedTriangles = 0;
  /// Whether others have taken the place of the plane.
  bool HasGone = false;
  /// Whether a local map has surface here. A facet has none, nor has a plane that went.
  bool HasSurface = false;
  /// The creases with other planes, by their numbers, metres.
  std::map<int, lms3dCrease> Creases;
  /// The triangle of a local map, if the region is nothing else. It need not lie exactly in the
  /// plane.
  std::vector<std::array<lms3dVector, 3>> Verbatim;

  lms3dRegionShape Shape;
  /// A tile keeps its place. A plane that is a triangle of a local map uses one.
  std::deque<lms3dFusedTile> Tiles;
  /// The tiles before this one have blocks. The others were of planes that went.
  int UsedTiles = 0;
  /// Blocks before this one have tiles.
  int TiledBlocks = 0;
  /// Creases are drawn on blocks before this one.
  int ShapedBlocks = 0;
  lms3dBlockIndex TileNumbers;

  /// Whether creases are longer than in Shape.
  bool HasNewCreases = false;
  /// Blocks before this one are not new.
  int OldBlocks = 0;

private:
  lms3dBlockGroups Groups;
  lms3dWorldBox BoxOfBlocks;
  /// The blocks before this one are in the box.
  int BoxedBlocks = 0;
};

#endif
