// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A square part of a plane of a fused map: the region whose triangles change at once.
 */
#ifndef lms3dFusedTile_h
#define lms3dFusedTile_h

#include "Fusion/Cells/lms3dFusedMesh.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

struct lms3dFusedTile
{
  using Cell = std::array<std::int32_t, 2>;

  /// The blocks along a side. So a tile is 683 times as wide as the error bound.
  static constexpr int Size = 32;

  /// The number of the tile along an axis with a block. Tiles are shifted by half of their size,
  /// so that the first cell, where the plane was seen first, lies in the middle of a tile.
  static std::int32_t GetTileOf(std::int32_t block) { return (block + Size / 2) >> 5; }

  /// The tile with all cells of its plane.
  lms3dFusedTile() = default;

  lms3dFusedTile(std::int32_t u, std::int32_t v)
    : Left((u * Size - Size / 2) * lms3dRaster::Size)
    , Bottom((v * Size - Size / 2) * lms3dRaster::Size)
    , Right(this->Left + Size * lms3dRaster::Size)
    , Top(this->Bottom + Size * lms3dRaster::Size)
  {
  }

  /// The cells.
  lms3dCellBox GetCells() const
  {
    return { this->Left, this->Right - 1, this->Bottom, this->Top - 1 };
  }

  bool IsOnSide(const lms3dPoint2& point, int axis) const
  {
    return point[axis] == (axis == 0 ? this->Left : this->Bottom) ||
      point[axis] == (axis == 0 ? this->Right : this->Top);
  }

  bool Has(const lms3dPoint2& point) const
  {
    return point[0] >= this->Left && point[0] <= this->Right && point[1] >= this->Bottom &&
      point[1] <= this->Top;
  }

  bool HasBlock(std::int32_t u, std::int32_t v) const
  {
    return this->Has({ (u + 0.5) * lms3dRaster::Size, (v + 0.5) * lms3dRaster::Size });
  }

  /// Whether the mesh differs so much from the shape that it is made anew. A large tile may differ
  /// by a share of its cells, so that a surface which grows little by little is not made anew with
  /// each scan; but not near creases, where it would leave gaps to other planes.
  bool HasOtherShape() const
  {
    constexpr int Largest = 256;
    constexpr int LargestOfBlock = 16;
    constexpr int LargestAtCreases = 64;
    return this->DifferenceAtCreases > LargestAtCreases ||
      (this->Difference > Largest &&
        this->Difference / LargestOfBlock > static_cast<int>(this->Blocks.size()));
  }

  /// Cells: the sides.
  std::int32_t Left = std::numeric_limits<std::int32_t>::min();
  std::int32_t Bottom = std::numeric_limits<std::int32_t>::min();
  std::int32_t Right = std::numeric_limits<std::int32_t>::max();
  std::int32_t Top = std::numeric_limits<std::int32_t>::max();

  std::vector<int> Blocks;
  lms3dFusedMesh Mesh;
  /// The cells of returns that have facets.
  std::vector<Cell> Facets;
  int Revision = 0;
  /// How many cells of its blocks differ between Shape and Meshed, and how many of them are near
  /// creases.
  int Difference = 0;
  int DifferenceAtCreases = 0;
  /// Whether the mesh does not explain what scans saw.
  bool IsStale = true;
  /// Whether the last scan has returns here.
  bool IsSeen = true;
};

#endif
