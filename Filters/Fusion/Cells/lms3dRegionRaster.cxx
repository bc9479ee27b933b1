// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dRegionRaster.h"

#include "Fusion/Cells/lms3dCellWindow.h"
#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// A block and those around it, row by row; nullptr where there is none.
using Around = std::array<const lms3dRasterBlock*, 9>;
constexpr int Middle = 4;

Around FindAround(const lms3dRaster& raster, int number)
{
  const lms3dRasterBlock& block = raster.GetBlock(number);
  Around around;
  for (int i = 0; i < 9; ++i)
  {
    const int other = block.Around[i];
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

// `hasBits` may be nullptr.
lms3dCellWindow MakeWindow(
  const Around& around, lms3dRaster::BitsOf bits, bool lms3dRasterBlock::*hasBits = nullptr)
{
  lms3dCellWindow window;
  for (int i = 0; i < 9; ++i)
  {
    if (around[i] && (!hasBits || around[i]->*hasBits))
    {
      window.Add(i % 3 - 1, i / 3 - 1, around[i]->*bits);
    }
  }
  return window;
}

const std::uint64_t* GetPassed(const lms3dRasterBlock* block)
{
  return block && block->HasPassed ? block->Passed.data() : lms3dNoBits.data();
}

// The cells of a row of a block, and those beside them.
inline std::uint64_t WidenRow(
  const std::uint64_t* left, const std::uint64_t* middle, const std::uint64_t* right, int row)
{
  return middle[row] | middle[row] << 1U | middle[row] >> 1U | left[row] >> Last |
    right[row] << Last;
}

// Takes cells beside the cells of a block out of `cells`. `wide` is for its rows, and one row on
// either side.
LMS3D_WIDE_LOOPS void TakeOutBeside(const std::uint64_t* left, const std::uint64_t* middle,
  const std::uint64_t* right, std::uint64_t* wide, std::uint64_t* cells)
{
  for (int row = 0; row <= Last; ++row)
  {
    wide[row + 1] = WidenRow(left, middle, right, row);
  }
  for (int row = 0; row <= Last; ++row)
  {
    cells[row] &= ~(wide[row] | wide[row + 1] | wide[row + 2]);
  }
}

// Returns the cells with returns that no border may cut off: those without a beam that passed
// beside them.
lms3dBits GetSureReturns(const Around& around)
{
  lms3dBits sure = around[Middle]->Must;
  if (std::any_of(around.begin(), around.end(),
        [](const lms3dRasterBlock* block) { return block && block->HasPassed; }))
  {
    std::array<const std::uint64_t*, 9> passed = {};
    std::transform(around.begin(), around.end(), passed.begin(), GetPassed);
    std::array<std::uint64_t, lms3dRaster::Size + 2> wide;
    wide.front() = WidenRow(passed[0], passed[1], passed[2], Last);
    wide.back() = WidenRow(passed[6], passed[7], passed[8], 0);
    TakeOutBeside(passed[3], passed[Middle], passed[5], wide.data(), sure.data());
  }
  return sure;
}

// The cells of the block whose side decides on the shape: gaps that returns may take, and cells of
// the region that beams may take.
lms3dCellWindow FindUndecided(const lms3dCellWindow& gaps, const lms3dCellWindow& region,
  const lms3dCellWindow& returns, const lms3dCellWindow& beams)
{
  lms3dCellWindow undecided;
  undecided.Add(0, 0, gaps.GetMiddle());
  if (undecided.HasCells())
  {
    undecided &= returns.GetReachOfRace();
  }
  if (beams.HasCells())
  {
    lms3dCellWindow taken;
    taken.Add(0, 0, region.GetMiddle());
    taken &= beams.GetReachOfRace();
    undecided |= taken;
  }
  return undecided;
}

// Finds May and the disputed squares of a region.
lms3dRegionCells FindRegion(const Around& around)
{
  const lms3dCellWindow passed =
    MakeWindow(around, &lms3dRasterBlock::Passed, &lms3dRasterBlock::HasPassed);
  lms3dCellWindow returns = MakeWindow(around, &lms3dRasterBlock::Must);
  lms3dCellWindow may = MakeWindow(around, &lms3dRasterBlock::May);
  lms3dCellWindow region = may;
  region -= MakeWindow(around, &lms3dRasterBlock::Open, &lms3dRasterBlock::HasOpen);
  region |= returns;
  region -= passed;
  lms3dCellWindow near = region;
  near.Close();
  near |= may;
  lms3dCellWindow disputed = near;
  disputed -= passed;
  near -= region;
  returns -= passed;
  lms3dCellWindow beams = passed;
  lms3dCellWindow::Race(FindUndecided(near, region, returns, passed), returns, beams);
  near &= returns;
  region -= beams;
  region |= near;
  disputed -= region;
  lms3dRegionCells cells = { region.GetMiddle(), {}, {} };
  cells.Squares.Disputed = lms3dGetSquares(disputed.GetMiddle());
  return cells;
}
} // namespace

lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks)
{
  lms3dRegion region;
  for (const int number : blocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    lms3dRegionBlock& cells = region.GetBlock(region.Make(block.U, block.V));
    cells.Must = GetSureReturns(FindAround(raster, number));
    for (int row = 0; row <= Last; ++row)
    {
      cells.Far[row] = cells.Must[row] & block.Far[row];
    }
    if (block.HasPassed)
    {
      cells.Passed = block.Passed;
    }
  }
  return region;
}

lms3dRegionCells lms3dMakeRegionCells(const lms3dRaster& raster, int number)
{
  const lms3dRasterBlock& block = raster.GetBlock(number);
  const Around around = FindAround(raster, number);
  if (IsWhole(around))
  {
    return { block.May, block.Must, { ~lms3dSquares{ 0 }, 0, 0 } };
  }
  lms3dRegionCells cells = FindRegion(around);
  cells.Must = GetSureReturns(around);
  lms3dBits gaps;
  for (int row = 0; row <= Last; ++row)
  {
    cells.May[row] |= cells.Must[row];
    gaps[row] = ~cells.May[row];
  }
  cells.Squares.Some = lms3dGetSquares(cells.May);
  cells.Squares.Gaps = lms3dGetSquares(gaps);
  return cells;
}

// What changed since the region was made can be judged one by one, in any order: the squares of the
// region stay right until a change has an effect.
void lms3dMarkDependents(lms3dRaster& raster)
{
  // Marking adds blocks to the marked ones.
  const std::vector<int> marked = raster.GetMarked();
  for (const int number : marked)
  {
    if (!raster.HasMark(number, lms3dRaster::CHANGED))
    {
      continue;
    }
    lms3dRasterBlock& block = raster.GetBlock(number);
    const lms3dChangedSquares changes = std::exchange(block.Changes, {});
    for (int i = 0; i < 9; ++i)
    {
      const int u = i % 3 - 1;
      const int v = i / 3 - 1;
      const int other = changes.AreNear(u, v) ? block.Around[i] : -1;
      if (other >= 0 && !raster.HasMark(other, lms3dRaster::DIRTY) &&
        raster.GetBlock(other).Region.DependOn(changes, -u, -v))
      {
        raster.SetMark(other, lms3dRaster::DIRTY);
      }
    }
  }
}
