// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells that the region of a plane covers, block by block.
 */
#ifndef lms3dRegionShape_h
#define lms3dRegionShape_h

#include "Fusion/lms3dBlockParts.h"
#include "Fusion/lms3dCreaseLine.h"
#include "Fusion/lms3dCreaseMask.h"
#include "Fusion/lms3dRaster.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * The shape are the cells of lms3dMakeRegion() that are joined to a return without a way across a
 * crease: a scan from afar guesses surface beyond the crease, and a scan from nearby sees that the
 * surface ends there. Returns keep their cells, and a few cells beyond the crease stay, from which
 * corners move to the crease.
 *
 * Only blocks that changed are made anew. For the others, the parts into which creases and borders
 * divide a block are kept, and how they touch the sides of the block.
 */
class lms3dRegionShape
{
public:
  /// Makes the Shape of the blocks that are marked as dirty, and of those that depend on them.
  /// Returns the blocks whose Shape changed, or at which creases are longer than before, in order.
  std::vector<int> Update(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster);

private:
  /// The sides of a block: left, right, bottom, top.
  using Sides = std::array<std::uint64_t, 4>;

  struct Part
  {
    Sides Cells;
    bool HasReturn;
    bool IsReached;
  };

  struct BlockState
  {
    int Right = -1;
    int Above = -1;
    /// The number of the first part when all parts are numbered.
    int FirstPart = 0;
    std::vector<Part> Parts;
  };

  /// Blocks with their cells and parts.
  struct Round
  {
    std::vector<int> Blocks;
    lms3dRegion Region;
    std::vector<lms3dBlockParts> Parts;
  };

  void AddBlocks(const lms3dRaster& raster);
  Round MakeRound(std::vector<int> blocks, const lms3dRaster& raster);
  /// Returns the parts of each block.
  std::vector<lms3dBlockParts> FindParts(
    const std::vector<int>& blocks, const lms3dRegion& region, const lms3dRaster& raster);
  std::vector<int> FindReached();
  void Connect(std::vector<int>& links) const;
  void MakeShape(int number, const lms3dBlockParts& parts, const lms3dRegionBlock& cells,
    lms3dRaster& raster, std::vector<int>& changed) const;
  lms3dBits GetShape(int number, const lms3dBlockParts& parts, const lms3dRegionBlock& cells) const;
  lms3dBits GetFree(int number, const lms3dRegionBlock& cells) const;

  lms3dCreaseMask Creases;
  std::vector<BlockState> Blocks;
};

#endif
