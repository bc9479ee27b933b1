// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionRaster.h"

#include "Fusion/lms3dCellWindow.h"

#include <algorithm>
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

/// A block and those around it, row by row; nullptr where there is none.
using Around = std::array<const lms3dRasterBlock*, 9>;

Around FindAround(const lms3dRaster& raster, int number)
{
  const lms3dRasterBlock& block = raster.GetBlock(number);
  Around around;
  for (int i = 0; i < 9; ++i)
  {
    const int other = raster.Find(block.U + i % 3 - 1, block.V + i / 3 - 1);
    around[i] = other < 0 ? nullptr : &raster.GetBlock(other);
  }
  return around;
}

// Whether a local map has surface everywhere, and no beam passed.
bool IsWhole(const Around& around)
{
  return std::all_of(around.begin(), around.end(),
    [](const lms3dRasterBlock* block)
    { return block && block->IsFull && !block->HasPassed && !block->HasOpen; });
}

lms3dCellWindow MakeWindow(const Around& around, lms3dRaster::BitsOf bits)
{
  lms3dCellWindow window;
  for (int i = 0; i < 9; ++i)
  {
    if (around[i])
    {
      window.Add(i % 3 - 1, i / 3 - 1, around[i]->*bits);
    }
  }
  return window;
}

// Widens returns and beams that passed, step by step, until they meet. Octagons are nearly round.
void Share(lms3dCellWindow& returns, lms3dCellWindow& beams)
{
  for (int step = 1; step < lms3dCellWindow::Reach; ++step)
  {
    const int neighbours = step % 2 == 0 ? 8 : 4;
    lms3dCellWindow nextReturns = returns;
    nextReturns.Widen(neighbours);
    nextReturns -= beams;
    lms3dCellWindow nextBeams = beams;
    nextBeams.Widen(neighbours);
    nextBeams -= returns;
    lms3dCellWindow both = nextReturns;
    both &= nextBeams;
    returns = nextReturns;
    returns -= both;
    beams = nextBeams;
    beams -= both;
  }
}

lms3dBits FindRegion(const Around& around)
{
  const lms3dCellWindow passed = MakeWindow(around, &lms3dRasterBlock::Passed);
  lms3dCellWindow returns = MakeWindow(around, &lms3dRasterBlock::Must);
  lms3dCellWindow may = MakeWindow(around, &lms3dRasterBlock::May);
  lms3dCellWindow region = may;
  region -= MakeWindow(around, &lms3dRasterBlock::Open);
  region |= returns;
  region -= passed;
  lms3dCellWindow near = region;
  near.Close();
  near |= may;
  lms3dCellWindow beams = passed;
  returns -= passed;
  Share(returns, beams);
  near &= returns;
  region -= beams;
  region |= near;
  return region.GetMiddle();
}
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
    for (int row = 0; row <= Last; ++row)
    {
      cells.Far[row] = cells.Must[row] & block.Far[row];
    }
    cells.Passed = block.Passed;
  }
  return region;
}

lms3dRegionCells lms3dMakeRegionCells(const lms3dRaster& raster, int number)
{
  const lms3dRasterBlock& block = raster.GetBlock(number);
  const Around around = FindAround(raster, number);
  if (IsWhole(around))
  {
    return { block.May, block.Must };
  }
  lms3dRegionCells cells = { FindRegion(around), lms3dGetSureReturns(raster, block) };
  for (int row = 0; row <= Last; ++row)
  {
    cells.May[row] |= cells.Must[row];
  }
  return cells;
}

void lms3dMarkDependents(lms3dRaster& raster)
{
  // Marking adds blocks to the marked ones.
  const std::vector<int> marked = raster.GetMarked();
  for (const int number : marked)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (int i = 0; i < 9 && block.Changes != 0; ++i)
    {
      const int u = i % 3 - 1;
      const int v = i / 3 - 1;
      const int other = raster.Find(block.U + u, block.V + v);
      if (other >= 0 && block.HasChangesNear(u, v) &&
        !(raster.GetBlock(other).IsWhole && IsWhole(FindAround(raster, other))))
      {
        raster.SetMark(other, lms3dRaster::DIRTY);
      }
    }
    raster.GetBlock(number).Changes = 0;
  }
}
