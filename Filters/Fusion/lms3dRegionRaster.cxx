// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// The word of a row of passed cells, where rows -1 and 64 belong to the neighbours.
std::uint64_t GetWord(const lms3dRaster& raster, std::int32_t u, std::int32_t v, int row)
{
  const int above = row > Last ? 1 : 0;
  const int below = row < 0 ? 1 : 0;
  const int number = raster.Find(u, v + above - below);
  return number < 0 ? 0 : raster.GetBlock(number).Passed[row & Last];
}

/// A row of passed cells, widened by one cell on both sides.
std::uint64_t GetWideWord(const lms3dRaster& raster, const lms3dRasterBlock& block, int row)
{
  const std::uint64_t word = GetWord(raster, block.U, block.V, row);
  const std::uint64_t left = GetWord(raster, block.U - 1, block.V, row);
  const std::uint64_t right = GetWord(raster, block.U + 1, block.V, row);
  return word | word << 1 | word >> 1 | left >> Last | right << Last;
}

bool IsEmpty(const lms3dBits& bits)
{
  std::uint64_t all = 0;
  for (const std::uint64_t word : bits)
  {
    all |= word;
  }
  return all == 0;
}

bool HasPassedAround(const lms3dRaster& raster, const lms3dRasterBlock& block)
{
  for (int v = -1; v <= 1; ++v)
  {
    for (int u = -1; u <= 1; ++u)
    {
      const int number = raster.Find(block.U + u, block.V + v);
      if (number >= 0 && !IsEmpty(raster.GetBlock(number).Passed))
      {
        return true;
      }
    }
  }
  return false;
}

// Cells: how far around a beam that passed the region is taken out at most.
constexpr int LargestBall = 16;

/// The cells of a row from 31 before a cell to 31 behind it. Bit 31 is the cell itself.
std::uint64_t GetWindow(
  const lms3dRaster& raster, lms3dRaster::BitsOf bits, std::int32_t u, std::int32_t row)
{
  const std::int32_t first = u - 31;
  const int shift = lms3dRaster::GetPlaceOf(first);
  const std::int32_t block = lms3dRaster::GetBlockOf(first);
  const int left = raster.Find(block, lms3dRaster::GetBlockOf(row));
  const int right = shift < 2 ? -1 : raster.Find(block + 1, lms3dRaster::GetBlockOf(row));
  const int place = lms3dRaster::GetPlaceOf(row);
  const std::uint64_t low = left < 0 ? 0 : (raster.GetBlock(left).*bits)[place] >> shift;
  const std::uint64_t high =
    right < 0 ? 0 : (raster.GetBlock(right).*bits)[place] << (lms3dRaster::Size - shift);
  return (low | high) & (~std::uint64_t{ 0 } >> 1);
}

/// The distance along the longer axis of the nearest cell with a bit, cells, at most twice LargestBall.
int GetDistance(const lms3dRaster& raster, lms3dRaster::BitsOf bits, std::int32_t u, std::int32_t v)
{
  int nearest = 2 * LargestBall;
  for (int row = 0; row < nearest; ++row)
  {
    const std::uint64_t window =
      GetWindow(raster, bits, u, v + row) | GetWindow(raster, bits, u, v - row);
    for (int width = 0; width < nearest && width <= 31 && window != 0; ++width)
    {
      if (((window >> (31 + width) | window >> (31 - width)) & 1U) != 0)
      {
        nearest = std::max(row, width);
      }
    }
  }
  return nearest;
}

/// Calls `visit` with a row, its first and its last cell, for the cells that are nearer to a cell than to any cell
/// with a bit.
template <typename Visitor>
void ForBall(const lms3dRaster& raster, lms3dRaster::BitsOf other, std::int32_t u, std::int32_t v,
  const Visitor& visit)
{
  const int radius = (GetDistance(raster, other, u, v) - 1) / 2;
  for (int row = -radius; row <= radius; ++row)
  {
    const auto width =
      static_cast<int>(std::sqrt(static_cast<double>(radius * radius - row * row)));
    visit(v + row, u - width, u + width);
  }
}

/// Calls `visit` with the cells that have both bits.
template <typename Visitor>
void ForCells(const lms3dRaster& raster, lms3dRaster::BitsOf first, lms3dRaster::BitsOf second,
  const Visitor& visit)
{
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    for (int row = 0; row <= Last; ++row)
    {
      const std::uint64_t cells = (block.*first)[row] & (block.*second)[row];
      for (int place = 0; place <= Last && cells >> place != 0; ++place)
      {
        if ((cells >> place & 1U) != 0)
        {
          visit(block.U * lms3dRaster::Size + place, block.V * lms3dRaster::Size + row);
        }
      }
    }
  }
}

/// Gives the cells back that are nearer to a return than to any beam that passed.
void GiveBack(const lms3dRaster& raster, lms3dRaster& region)
{
  const auto giveRow = [&](std::int32_t row, std::int32_t first, std::int32_t last)
  { region.SetRow(&lms3dRasterBlock::Open, row, first, last, true, false, [](int) {}); };
  ForCells(raster, &lms3dRasterBlock::Must, &lms3dRasterBlock::Open,
    [&](std::int32_t u, std::int32_t v)
    { ForBall(raster, &lms3dRasterBlock::Passed, u, v, giveRow); });
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    lms3dRasterBlock& cells = region.GetBlock(i);
    for (int row = 0; row <= Last; ++row)
    {
      cells.May[row] |= cells.Open[row] & raster.GetBlock(i).May[row];
    }
  }
}

/// Takes the cells out that are nearer to a beam that passed than to any return.
void TakeOut(const lms3dRaster& raster, lms3dRaster& region)
{
  const auto takeRow = [&](std::int32_t row, std::int32_t first, std::int32_t last)
  { region.SetRow(&lms3dRasterBlock::May, row, first, last, false, false, [](int) {}); };
  ForCells(raster, &lms3dRasterBlock::Passed, &lms3dRasterBlock::May,
    [&](std::int32_t u, std::int32_t v)
    { ForBall(raster, &lms3dRasterBlock::Must, u, v, takeRow); });
}
} // namespace

lms3dRaster lms3dMakeRegion(const lms3dRaster& raster)
{
  lms3dRaster region;
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    lms3dRasterBlock& cells = region.GetBlock(region.Make(block.U, block.V));
    const bool isDisputed = HasPassedAround(raster, block);
    for (int row = 0; row <= Last; ++row)
    {
      const std::uint64_t disputed = isDisputed ? GetWideWord(raster, block, row - 1) |
          GetWideWord(raster, block, row) | GetWideWord(raster, block, row + 1)
                                                : 0;
      cells.Passed[row] = block.Passed[row];
      cells.Must[row] = block.Must[row] & ~disputed;
      cells.May[row] = (block.May[row] & ~block.Open[row] & ~block.Passed[row]) | cells.Must[row];
    }
  }
  GiveBack(raster, region);
  TakeOut(raster, region);
  return region;
}
