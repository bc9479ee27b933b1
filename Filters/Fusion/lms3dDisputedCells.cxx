// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dDisputedCells.h"

#include "Fusion/lms3dBalls.h"

#include <utility>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;
constexpr int Places = 9;

bool IsEmpty(const lms3dBits& bits)
{
  std::uint64_t all = 0;
  for (const std::uint64_t word : bits)
  {
    all |= word;
  }
  return all == 0;
}

/// The cells of a block that have two bits.
lms3dBits GetBoth(
  const lms3dRasterBlock& block, lms3dRaster::BitsOf a, lms3dBits lms3dRasterBlock::*b)
{
  lms3dBits both;
  for (int row = 0; row <= Last; ++row)
  {
    both[row] = (block.*a)[row] & (block.*b)[row];
  }
  return both;
}

/// The returns around which balls lie.
lms3dBits GetDisputedReturns(const lms3dRasterBlock& block)
{
  return GetBoth(block, &lms3dRasterBlock::Must, &lms3dRasterBlock::Open);
}

bool HasCentres(const lms3dRasterBlock& block)
{
  return (block.HasPassed &&
           !IsEmpty(GetBoth(block, &lms3dRasterBlock::Passed, &lms3dRasterBlock::May))) ||
    !IsEmpty(GetDisputedReturns(block));
}

/// The cells that balls may take, apart from cells that others gave back.
lms3dBits GetClosed(const lms3dRasterBlock& block)
{
  lms3dBits closed;
  for (int row = 0; row <= Last; ++row)
  {
    closed[row] = block.May[row] & ~block.Open[row];
  }
  return closed;
}

/// The beams that passed around which balls lie. Balls that are too far away from all cells of the
/// region are left out.
lms3dBits GetDisputedBeams(const lms3dRaster& raster, const lms3dRasterBlock& block)
{
  lms3dBits centres = GetBoth(block, &lms3dRasterBlock::Passed, &lms3dRasterBlock::May);
  if (IsEmpty(centres) || !lms3dBlockWindow(raster, block, GetDisputedReturns).IsEmpty())
  {
    return centres;
  }
  const lms3dBits near = lms3dBlockWindow(raster, block, GetClosed).GetCellsNear();
  for (int row = 0; row <= Last; ++row)
  {
    centres[row] &= near[row];
  }
  return centres;
}
} // namespace

lms3dDisputedCells::Cells::Cells(const lms3dBalls& balls)
{
  balls.ForRows(
    [this](int row, const std::array<std::uint64_t, 3>& words)
    {
      if (this->Rows.empty())
      {
        this->First = row;
      }
      this->Rows.resize(static_cast<std::size_t>(row - this->First));
      this->Rows.push_back(words);
    });
}

lms3dDisputedCells::Shares lms3dDisputedCells::MakeShares(
  const lms3dRaster& raster, const lms3dRasterBlock& block)
{
  Shares shares;
  const lms3dBits returns = GetDisputedReturns(block);
  if (!IsEmpty(returns))
  {
    shares.Given =
      Cells(lms3dBalls(returns, lms3dBlockWindow(raster, block, &lms3dRasterBlock::Passed)));
  }
  const lms3dBits beams = GetDisputedBeams(raster, block);
  if (!IsEmpty(beams))
  {
    shares.Taken =
      Cells(lms3dBalls(beams, lms3dBlockWindow(raster, block, &lms3dRasterBlock::Must)));
  }
  return shares;
}

void lms3dDisputedCells::AddBlocks(const lms3dRaster& raster)
{
  const auto before = static_cast<int>(this->Blocks.size());
  this->Blocks.resize(static_cast<std::size_t>(raster.GetNumberOfBlocks()));
  for (int number = before; number < raster.GetNumberOfBlocks(); ++number)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (int place = 0; place < Places; ++place)
    {
      const int other = raster.Find(block.U + place % 3 - 1, block.V + place / 3 - 1);
      this->Blocks[number].Around[place] = other;
      if (other >= 0)
      {
        this->Blocks[other].Around[Places - 1 - place] = number;
      }
    }
  }
}

// Returns the blocks whose balls may change.
std::vector<int> lms3dDisputedCells::FindBlocks(const lms3dRaster& raster)
{
  std::vector<int> blocks;
  const auto add = [&](int number)
  {
    if (!this->Blocks[number].IsListed)
    {
      this->Blocks[number].IsListed = true;
      blocks.push_back(number);
    }
  };
  for (const int number : raster.GetMarked())
  {
    if (raster.HasMark(number, lms3dRaster::DISPUTED))
    {
      this->Blocks[number].HasCentres = HasCentres(raster.GetBlock(number));
      add(number);
    }
  }
  for (const int number : raster.GetMarked())
  {
    if (!raster.HasMark(number, lms3dRaster::AROUND))
    {
      continue;
    }
    for (const int other : this->Blocks[number].Around)
    {
      if (other >= 0 && this->Blocks[other].HasCentres)
      {
        add(other);
      }
    }
  }
  return blocks;
}

// Marks the blocks with May in which cells change hands.
void lms3dDisputedCells::MarkChanges(
  const Shares& before, const Shares& now, int number, lms3dRaster& raster) const
{
  for (int place = 0; place < Places; ++place)
  {
    const int other = this->Blocks[number].Around[place];
    const int u = place % 3 - 1;
    const int v = place / 3 - 1;
    std::uint64_t changed = 0;
    for (int row = 0; other >= 0 && row <= Last; ++row)
    {
      changed |= ((before.Given.Get(u, v, row) ^ now.Given.Get(u, v, row)) |
                   (before.Taken.Get(u, v, row) ^ now.Taken.Get(u, v, row))) &
        raster.GetBlock(other).May[row];
    }
    if (changed != 0)
    {
      raster.SetMark(other, lms3dRaster::DIRTY);
    }
  }
}

void lms3dDisputedCells::Update(lms3dRaster& raster)
{
  this->AddBlocks(raster);
  for (const int number : this->FindBlocks(raster))
  {
    Block& block = this->Blocks[number];
    Shares now = MakeShares(raster, raster.GetBlock(number));
    this->MarkChanges(block.Kept ? *block.Kept : Shares(), now, number, raster);
    block.Kept = now.Given.IsEmpty() && now.Taken.IsEmpty()
      ? nullptr
      : std::make_unique<Shares>(std::move(now));
    block.IsListed = false;
  }
}

void lms3dDisputedCells::Divide(const lms3dRaster& raster, int number, lms3dBits& cells) const
{
  lms3dBits given = {};
  lms3dBits taken = {};
  for (int place = 0; place < Places; ++place)
  {
    const int other = this->Blocks[number].Around[place];
    const Shares* const shares = other < 0 ? nullptr : this->Blocks[other].Kept.get();
    for (int row = 0; shares && row <= Last; ++row)
    {
      given[row] |= shares->Given.Get(1 - place % 3, 1 - place / 3, row);
      taken[row] |= shares->Taken.Get(1 - place % 3, 1 - place / 3, row);
    }
  }
  const lms3dBits& may = raster.GetBlock(number).May;
  for (int row = 0; row <= Last; ++row)
  {
    cells[row] = (cells[row] | (given[row] & may[row])) & ~taken[row];
  }
}
