// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dTileSides.h"

#include <cstdint>

namespace
{
// Cells.
constexpr int LargestGap = 16;
constexpr int Last = lms3dRaster::Size - 1;

/// The cells of a tile along one of its sides.
class Side
{
public:
  /// `axis` is that along the side.
  Side(const lms3dFusedTile& tile, int axis, bool isFar, lms3dRegion& region)
    : Region(region)
    , Axis(axis)
    , Start(lms3dRaster::GetBlockOf(axis == 0 ? tile.Left : tile.Bottom))
    , Across(lms3dRaster::GetBlockOf(axis == 0 ? tile.Bottom : tile.Left) +
        (isFar ? lms3dFusedTile::Size - 1 : 0))
    , Place(isFar ? Last : 0)
  {
  }

  void Close()
  {
    // Where the last cell with May was, if no beam passed since.
    int from = -1;
    int cell = 0;
    for (int i = 0; i < lms3dFusedTile::Size; ++i)
    {
      const int number = this->Find(i);
      if (number < 0)
      {
        from = -1;
        cell += lms3dRaster::Size;
        continue;
      }
      const std::uint64_t may = this->Get(number, &lms3dRasterBlock::May);
      const std::uint64_t passed = this->Get(number, &lms3dRasterBlock::Passed);
      for (int bit = 0; bit <= Last; ++bit, ++cell)
      {
        from = (passed >> bit & 1U) != 0 ? -1 : from;
        if ((may >> bit & 1U) != 0)
        {
          this->Fill(from >= 0 && cell - from <= LargestGap ? from : cell, cell);
          from = cell;
        }
      }
    }
  }

private:
  int Find(int i) const
  {
    return this->Axis == 0 ? this->Region.Find(this->Start + i, this->Across)
                           : this->Region.Find(this->Across, this->Start + i);
  }

  std::uint64_t Get(int number, lms3dRegion::BitsOf bits) const
  {
    const lms3dBits& rows = this->Region.GetBlock(number).*bits;
    if (this->Axis == 0)
    {
      return rows[this->Place];
    }
    std::uint64_t word = 0;
    for (int row = 0; row <= Last; ++row)
    {
      word |= (rows[row] >> this->Place & 1U) << row;
    }
    return word;
  }

  /// The cells between two.
  void Fill(int from, int to)
  {
    for (int cell = from + 1; cell < to; ++cell)
    {
      lms3dBits& may = this->Region.GetBlock(this->Find(cell / lms3dRaster::Size)).May;
      const int place = cell % lms3dRaster::Size;
      may[this->Axis == 0 ? this->Place : place] |= std::uint64_t{ 1 }
        << (this->Axis == 0 ? place : this->Place);
    }
  }

  lms3dRegion& Region;
  const int Axis;
  /// The first block along the side.
  const std::int32_t Start;
  /// The block across the side, and the place of the cells in it.
  const std::int32_t Across;
  const int Place;
};
} // namespace

void lms3dCloseGapsAlongSides(const lms3dFusedTile& tile, lms3dRegion& region)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (const bool isFar : { false, true })
    {
      Side(tile, axis, isFar, region).Close();
    }
  }
}

void lms3dAddBlocksAround(const lms3dFusedTile& tile, lms3dRegion& region)
{
  const int count = region.GetNumberOfBlocks();
  for (int number = 0; number < count; ++number)
  {
    const std::int32_t middleU = region.GetBlock(number).U;
    const std::int32_t middleV = region.GetBlock(number).V;
    if (tile.HasBlock(middleU - 1, middleV - 1) && tile.HasBlock(middleU + 1, middleV + 1))
    {
      continue;
    }
    for (std::int32_t v = middleV - 1; v <= middleV + 1; ++v)
    {
      for (std::int32_t u = middleU - 1; u <= middleU + 1; ++u)
      {
        if (!tile.HasBlock(u, v))
        {
          region.Make(u, v);
        }
      }
    }
  }
}
