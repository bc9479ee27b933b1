// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells that the region of a plane covers, block by block.
 */
#ifndef lms3dRegionShape_h
#define lms3dRegionShape_h

#include "Fusion/Cells/lms3dBlockParts.h"
#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Cells/lms3dCreaseMask.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Cells/lms3dReachedParts.h"
#include "Fusion/Cells/lms3dRegionRaster.h"

#include <vector>

/**
 * The shape are the cells of lms3dMakeRegionCells() that are joined to a return without a way
 * across a crease: a scan from afar guesses surface beyond the crease, and a scan from nearby sees
 * that the surface ends there. Returns keep their cells, and a few cells beyond the crease stay,
 * from which corners move to the crease.
 *
 * Only blocks that changed are made anew. For the others, the parts into which creases and borders
 * divide a block are kept.
 */
class lms3dRegionShape
{
public:
  /// Makes the Shape of the blocks that are marked as dirty, and of those that depend on them.
  /// Returns the blocks whose Shape changed, or at which creases are longer than before, in order.
  std::vector<int> Update(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster);

private:
  /// Blocks with their cells and parts.
  struct Round
  {
    std::vector<int> Blocks;
    std::vector<lms3dRegionCells> Cells;
    std::vector<lms3dBlockParts> Parts;
  };

  Round MakeRound(std::vector<int> blocks, const lms3dRaster& raster);
  void MakeShape(int number, const lms3dBlockParts& parts, const lms3dRegionCells& cells,
    lms3dRaster& raster, std::vector<int>& changed) const;
  lms3dBits GetShape(int number, const lms3dBlockParts& parts, const lms3dRegionCells& cells) const;
  lms3dBits GetFree(int number, const lms3dRegionCells& cells) const;
  lms3dBits GetReturns(int number, const lms3dRasterBlock& block) const;

  lms3dCreaseMask Creases;
  lms3dReachedParts Reached;
};

#endif
