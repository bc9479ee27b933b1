// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

#include "Fusion/lms3dBalls.h"

#include <algorithm>
#include <array>
#include <cstdint>
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

/// The cells of a block that have two bits.
lms3dBits GetBoth(const lms3dRasterBlock& block, lms3dRaster::BitsOf a, lms3dRaster::BitsOf b)
{
  lms3dBits both;
  for (int row = 0; row <= Last; ++row)
  {
    both[row] = (block.*a)[row] & (block.*b)[row];
  }
  return both;
}

/// Calls `visit` with a number of a block of the region, a row and bits, for the balls around the
/// cells that `getCentres` returns for a block. The balls keep away from the cells with the bit
/// `others`.
template <typename Getter, typename Visitor>
void ForBalls(const lms3dRaster& raster, const std::vector<int>& blocks, const Getter& getCentres,
  lms3dRaster::BitsOf others, const lms3dRegion& region, const Visitor& visit)
{
  for (const int i : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    const lms3dBits centres = getCentres(block);
    if (IsEmpty(centres))
    {
      continue;
    }
    std::array<int, 9> numbers = {};
    for (int place = 0; place < 9; ++place)
    {
      numbers[place] = region.Find(block.U + place % 3 - 1, block.V + place / 3 - 1);
    }
    const lms3dBalls balls(centres, lms3dBlockWindow(raster, block, others));
    balls.ForRows(
      [&](int row, const std::array<std::uint64_t, 3>& words)
      {
        const int first = row < 0 ? 0 : (row > Last ? 6 : 3);
        for (int u = 0; u < 3; ++u)
        {
          if (numbers[first + u] >= 0 && words[u] != 0)
          {
            visit(numbers[first + u], row & Last, words[u]);
          }
        }
      });
  }
}

/// Gives the cells back that are nearer to a return than to any beam that passed.
void GiveBack(const lms3dRaster& raster, const std::vector<int>& blocks,
  const std::vector<int>& blocksOfRegion, lms3dRegion& region)
{
  ForBalls(
    raster, blocks,
    [](const lms3dRasterBlock& block)
    { return GetBoth(block, &lms3dRasterBlock::Must, &lms3dRasterBlock::Open); },
    &lms3dRasterBlock::Passed, region,
    [&](int number, int row, std::uint64_t bits)
    {
      const lms3dBits& may = raster.GetBlock(blocksOfRegion[number]).May;
      region.GetBlock(number).May[row] |= bits & may[row];
    });
}

/// Takes the cells out that are nearer to a beam that passed than to any return.
void TakeOut(const lms3dRaster& raster, const std::vector<int>& blocks, lms3dRegion& region)
{
  // Balls that are too far from the region take nothing out.
  const auto getCentres = [&](const lms3dRasterBlock& block)
  {
    lms3dBits centres = GetBoth(block, &lms3dRasterBlock::Passed, &lms3dRasterBlock::May);
    if (!IsEmpty(centres))
    {
      const lms3dBits near = lms3dBlockWindow(region, block, &lms3dRasterBlock::May).GetCellsNear();
      for (int row = 0; row <= Last; ++row)
      {
        centres[row] &= near[row];
      }
    }
    return centres;
  };
  ForBalls(raster, blocks, getCentres, &lms3dRasterBlock::Must, region,
    [&](int number, int row, std::uint64_t bits) { region.GetBlock(number).May[row] &= ~bits; });
}

void CopySure(const lms3dRasterBlock& block, const PassedAround& passed, bool hasPassed,
  lms3dRegionBlock& cells)
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

std::vector<int> lms3dFindDirtyBlocks(const lms3dRaster& raster)
{
  std::vector<int> widelyDirty;
  std::vector<int> dirty;
  for (const int number : raster.GetMarked())
  {
    if (raster.HasMark(number, lms3dRaster::DIRTY_AROUND))
    {
      widelyDirty.push_back(number);
    }
    if (raster.HasMark(number, lms3dRaster::DIRTY))
    {
      dirty.push_back(number);
    }
  }
  std::vector<int> blocks = lms3dFindBlocksAround(raster, widelyDirty);
  blocks.insert(blocks.end(), dirty.begin(), dirty.end());
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRegion region;
  PassedAround passed(raster);
  for (const int number : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    lms3dRegionBlock& cells = region.GetBlock(region.Make(block.U, block.V));
    const bool isPassed = passed.MoveTo(block);
    CopySure(block, passed, isPassed, cells);
  }
  return region;
}

lms3dRegion lms3dMakeRegion(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRegion region = lms3dCopySureReturns(raster, blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(blocks[i]);
    lms3dRegionBlock& cells = region.GetBlock(static_cast<int>(i));
    for (int row = 0; row <= Last; ++row)
    {
      cells.May[row] = (block.May[row] & ~block.Open[row] & ~block.Passed[row]) | cells.Must[row];
    }
  }
  const std::vector<int> around = lms3dFindBlocksAround(raster, blocks);
  GiveBack(raster, around, blocks, region);
  TakeOut(raster, around, region);
  return region;
}
