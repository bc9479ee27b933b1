// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane on creases, and those near them.
 */
#ifndef lms3dCreaseMask_h
#define lms3dCreaseMask_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Cells/lms3dRaster.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

/// Blocks have the numbers of the raster.
class lms3dCreaseMask
{
public:
  struct Cells
  {
    lms3dBits Line = {};
    lms3dBits Near = {};
  };

  /// Draws creases on the blocks of a raster. What was drawn before is drawn on new blocks alone.
  /// Blocks with new cells are marked as dirty, and count them.
  void Draw(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster);

  /// Returns nullptr for a block without cells.
  const Cells* Get(int block) const
  {
    return block < static_cast<int>(this->Blocks.size()) ? this->Blocks[block].get() : nullptr;
  }

private:
  using BitsOf = lms3dBits Cells::*;
  using Rectangle = std::array<lms3dPoint2, 4>;

  /// Blocks before the first one stay as they are.
  void Draw(const lms3dCreaseLine& crease, int firstBlock, lms3dRaster& raster);
  void Draw(BitsOf bits, const Rectangle& corners, int firstBlock, lms3dRaster& raster);
  void Draw(
    BitsOf bits, const lms3dCellStrip& strip, std::int32_t u, int firstBlock, lms3dRaster& raster);

  std::vector<std::unique_ptr<Cells>> Blocks;
  /// The creases that these blocks have, without Seen.
  std::vector<lms3dCreaseLine> Drawn;
};

#endif
