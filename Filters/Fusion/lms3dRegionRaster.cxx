// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

#include <array>
#include <cstdint>
#include <vector>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// The passed cells of a block and of its eight neighbours.
class PassedAround
{
public:
  explicit PassedAround(const lms3dRaster& raster)
    : Raster(raster)
  {
  }

  /// Returns whether there is a passed cell.
  bool MoveTo(const lms3dRasterBlock& block)
  {
    bool hasAny = false;
    for (int v = 0; v < 3; ++v)
    {
      for (int u = 0; u < 3; ++u)
      {
        const int number = this->Raster.Find(block.U + u - 1, block.V + v - 1);
        const bool isPassed = number >= 0 && this->Raster.GetBlock(number).HasPassed;
        this->Bits[v][u] = isPassed ? &this->Raster.GetBlock(number).Passed : &this->None;
        hasAny = hasAny || isPassed;
      }
    }
    return hasAny;
  }

  /// A row, from -1 to 64, widened by one cell on both sides.
  std::uint64_t GetWideWord(int row) const
  {
    const auto& bits = this->Bits[row < 0 ? 0 : (row > Last ? 2 : 1)];
    const std::uint64_t word = (*bits[1])[row & Last];
    return word | word << 1 | word >> 1 | (*bits[0])[row & Last] >> Last |
      (*bits[2])[row & Last] << Last;
  }

private:
  const lms3dRaster& Raster;
  const lms3dBits None = {};
  std::array<std::array<const lms3dBits*, 3>, 3> Bits = {};
};

} // namespace

lms3dBits lms3dGetSureReturns(const lms3dRaster& raster, const lms3dRasterBlock& block)
{
  lms3dBits sure = block.Must;
  PassedAround passed(raster);
  if (passed.MoveTo(block))
  {
    for (int row = 0; row <= Last; ++row)
    {
      sure[row] &=
        ~(passed.GetWideWord(row - 1) | passed.GetWideWord(row) | passed.GetWideWord(row + 1));
    }
  }
  return sure;
}

lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRegion region;
  for (const int number : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    lms3dRegionBlock& cells = region.GetBlock(region.Make(block.U, block.V));
    cells.Must = lms3dGetSureReturns(raster, block);
    cells.Passed = block.Passed;
  }
  return region;
}

lms3dRegionCells lms3dMakeRegionCells(
  const lms3dRaster& raster, int number, const lms3dDisputedCells& disputed)
{
  const lms3dRasterBlock& block = raster.GetBlock(number);
  lms3dRegionCells cells = { {}, lms3dGetSureReturns(raster, block) };
  for (int row = 0; row <= Last; ++row)
  {
    cells.May[row] = (block.May[row] & ~block.Open[row] & ~block.Passed[row]) | cells.Must[row];
  }
  disputed.Divide(raster, number, cells.May);
  return cells;
}
