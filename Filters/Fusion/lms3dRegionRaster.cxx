// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

bool IsEmpty(const lms3dBits& bits)
{
  std::uint64_t all = 0;
  for (const std::uint64_t word : bits)
  {
    all |= word;
  }
  return all == 0;
}

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
        const bool isPassed = number >= 0 && !IsEmpty(this->Raster.GetBlock(number).Passed);
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

/// Calls `visit` with the cells of blocks that have both bits.
template <typename Visitor>
void ForCells(const lms3dRaster& raster, const std::vector<int>& blocks, lms3dRaster::BitsOf first,
  lms3dRaster::BitsOf second, const Visitor& visit)
{
  for (const int i : blocks)
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
void GiveBack(const lms3dRaster& raster, const std::vector<int>& blocks, lms3dRaster& region)
{
  const auto giveRow = [&](std::int32_t row, std::int32_t first, std::int32_t last)
  { region.SetRow(&lms3dRasterBlock::Open, row, first, last, true, false, [](int) {}); };
  ForCells(raster, blocks, &lms3dRasterBlock::Must, &lms3dRasterBlock::Open,
    [&](std::int32_t u, std::int32_t v)
    { ForBall(raster, &lms3dRasterBlock::Passed, u, v, giveRow); });
  for (int i = 0; i < region.GetNumberOfBlocks(); ++i)
  {
    lms3dRasterBlock& cells = region.GetBlock(i);
    const lms3dBits& may = raster.GetBlock(raster.Find(cells.U, cells.V)).May;
    for (int row = 0; row <= Last; ++row)
    {
      cells.May[row] |= cells.Open[row] & may[row];
    }
  }
}

/// Takes the cells out that are nearer to a beam that passed than to any return.
void TakeOut(const lms3dRaster& raster, const std::vector<int>& blocks, lms3dRaster& region)
{
  const auto takeRow = [&](std::int32_t row, std::int32_t first, std::int32_t last)
  { region.SetRow(&lms3dRasterBlock::May, row, first, last, false, false, [](int) {}); };
  ForCells(raster, blocks, &lms3dRasterBlock::Passed, &lms3dRasterBlock::May,
    [&](std::int32_t u, std::int32_t v)
    { ForBall(raster, &lms3dRasterBlock::Must, u, v, takeRow); });
}

void CopySure(const lms3dRasterBlock& block, const PassedAround& passed, bool hasPassed,
  lms3dRasterBlock& cells)
{
  if (!hasPassed)
  {
    cells.Must = block.Must;
    return;
  }
  cells.Passed = block.Passed;
  for (int row = 0; row <= Last; ++row)
  {
    const std::uint64_t disputed =
      passed.GetWideWord(row - 1) | passed.GetWideWord(row) | passed.GetWideWord(row + 1);
    cells.Must[row] = block.Must[row] & ~disputed;
  }
}
} // namespace

std::vector<int> lms3dFindBlocksAround(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  std::vector<int> around;
  around.reserve(9 * blocks.size());
  for (const int number : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (std::int32_t v = block.V - 1; v <= block.V + 1; ++v)
    {
      for (std::int32_t u = block.U - 1; u <= block.U + 1; ++u)
      {
        around.push_back(raster.Find(u, v));
      }
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  around.erase(around.begin(), std::lower_bound(around.begin(), around.end(), 0));
  return around;
}

lms3dRaster lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRaster region;
  PassedAround passed(raster);
  for (const int number : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    lms3dRasterBlock& cells = region.GetBlock(region.Make(block.U, block.V));
    const bool isPassed = passed.MoveTo(block);
    cells.IsCalm = !isPassed && IsEmpty(block.Open);
    CopySure(block, passed, isPassed, cells);
  }
  return region;
}

lms3dRaster lms3dMakeRegion(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRaster region = lms3dCopySureReturns(raster, blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(blocks[i]);
    lms3dRasterBlock& cells = region.GetBlock(static_cast<int>(i));
    for (int row = 0; row <= Last; ++row)
    {
      cells.May[row] = (block.May[row] & ~block.Open[row] & ~block.Passed[row]) | cells.Must[row];
    }
  }
  const std::vector<int> around = lms3dFindBlocksAround(raster, blocks);
  GiveBack(raster, around, region);
  TakeOut(raster, around, region);
  return region;
}
