// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

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

/// The distance of the nearest cell with a bit, cells, at most twice LargestBall.
int GetDistance(const lms3dRaster& raster, lms3dRaster::BitsOf bits, std::int32_t u, std::int32_t v)
{
  int distance = 0;
  for (bool isFree = true; isFree && distance < 2 * LargestBall;)
  {
    ++distance;
    const auto isRowFree = [&](std::int32_t row)
    { return !raster.HasAny(bits, row, u - distance, u + distance); };
    isFree = isRowFree(v - distance) && isRowFree(v + distance);
    for (std::int32_t row = v - distance; isFree && row <= v + distance; ++row)
    {
      isFree = !raster.Has(bits, u - distance, row) && !raster.Has(bits, u + distance, row);
    }
  }
  return distance;
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
  {
    for (std::int32_t u = first; u <= last; ++u)
    {
      if (raster.Has(&lms3dRasterBlock::May, u, row))
      {
        region.SetRow(&lms3dRasterBlock::May, row, u, u, true, false, [](int) {});
      }
    }
  };
  ForCells(raster, &lms3dRasterBlock::Must, &lms3dRasterBlock::Open,
    [&](std::int32_t u, std::int32_t v)
    { ForBall(raster, &lms3dRasterBlock::Passed, u, v, giveRow); });
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
