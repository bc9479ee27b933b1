// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dRaster.h"

template <>
void lms3dBlockGrid<lms3dRasterBlock>::Link(int number)
{
  lms3dRasterBlock& block = this->Blocks[number];
  for (int i = 0; i < 9; ++i)
  {
    block.Around[i] = this->Find(block.U + i % 3 - 1, block.V + i / 3 - 1);
    if (block.Around[i] >= 0)
    {
      this->Blocks[block.Around[i]].Around[8 - i] = number;
    }
  }
}

void lms3dRaster::ClearMarks()
{
  for (const int number : this->Marked)
  {
    this->Blocks[number].Marks = 0;
  }
  this->Marked.clear();
}

// Calls `visit` with the number of each block, the first of its rows, and the bits of a row.
template <typename Visitor>
void lms3dRaster::ForWords(const lms3dCellStrip& strip, const Visitor& visit)
{
  const std::int32_t v = GetBlockOf(strip.Row);
  for (std::int32_t u = GetBlockOf(strip.Left); !strip.IsEmpty() && u <= GetBlockOf(strip.Right);
       ++u)
  {
    const int number = this->Find(u, v);
    for (int row = 0; number >= 0 && row < strip.Count; ++row)
    {
      visit(number, GetPlaceOf(strip.Row) + row, strip.GetBits(row, u * Size));
    }
  }
}

// A region has no cell of a beam that passed. More returns in a calm block change its shape only
// beside it. IsFull, HasPassed and HasOpen spare most looks at the bits.
void lms3dRaster::NoteReturn(int number, int row, std::uint64_t bit)
{
  const lms3dRasterBlock& block = this->Blocks[number];
  if (block.HasPassed && (block.Passed[row] & bit) != 0)
  {
    return;
  }
  const bool isInRegion = (block.IsFull || (block.May[row] & bit) != 0) &&
    !(block.HasOpen && (block.Open[row] & bit) != 0);
  this->AddChanges(
    number, isInRegion ? &lms3dChangedSquares::Returns : &lms3dChangedSquares::More, row, bit);
  if (!block.IsCalm || (block.Shape[row] & bit) == 0)
  {
    this->SetMark(number, DIRTY);
  }
}

void lms3dRaster::Pass(int number, int u, int v)
{
  lms3dRasterBlock& block = this->Blocks[number];
  const std::uint64_t bit = std::uint64_t{ 1 } << u;
  if ((block.Passed[v] & bit) != 0)
  {
    return;
  }
  block.Passed[v] |= bit;
  block.HasPassed = true;
  this->AddChanges(number, &lms3dChangedSquares::Less, v, bit);
}

void lms3dRaster::AddChanges(int number, ChangeOf change, int row, std::uint64_t cells)
{
  if (cells != 0)
  {
    this->Blocks[number].Changes.*change |= lms3dGetSquares(row, cells);
    this->SetMark(number, CHANGED);
  }
}

void lms3dRaster::Open(const lms3dCellStrip& strip)
{
  this->ForWords(strip,
    [this](int number, int row, std::uint64_t bits)
    {
      lms3dRasterBlock& block = this->Blocks[number];
      const std::uint64_t opened = bits & ~block.Open[row];
      const std::uint64_t inRegion = block.May[row] & ~(block.Must[row] | block.Passed[row]);
      block.Open[row] |= bits;
      block.HasOpen = block.HasOpen || bits != 0;
      this->AddChanges(number, &lms3dChangedSquares::Less, row, opened & inRegion);
      if (block.HasFilled && (opened & block.Touched[row] & ~block.Shape[row]) != 0)
      {
        this->SetMark(number, STALE);
      }
      if (opened != 0)
      {
        this->SetMark(number, CHANGED);
      }
    });
}

// A facet covers its cell and touches none.
void lms3dRaster::Forget(const lms3dCellStrip& strip)
{
  this->ForWords(strip,
    [this](int number, int row, std::uint64_t bits)
    {
      lms3dRasterBlock& block = this->Blocks[number];
      const std::uint64_t gone = bits & block.Must[row];
      const std::uint64_t forgotten = gone | (bits & block.Beside[row]);
      this->Forgot = this->Forgot || forgotten != 0;
      if ((forgotten & block.Covered[row] & ~block.Touched[row]) != 0)
      {
        this->SetMark(number, STALE);
      }
      block.Must[row] &= ~bits;
      block.Beside[row] &= ~bits;
      block.Far[row] &= ~bits;
      block.Halfway[row] &= ~bits;
      this->AddChanges(number, &lms3dChangedSquares::Less, row, gone);
    });
}

void lms3dRaster::AcceptGuess(int number)
{
  lms3dRasterBlock& block = this->Blocks[number];
  std::uint64_t all = ~std::uint64_t{ 0 };
  std::uint64_t added = 0;
  for (int row = 0; row < Size; ++row)
  {
    added |= block.Guess[row];
    block.May[row] |= block.Guess[row];
    all &= block.May[row];
    this->AddChanges(number, &lms3dChangedSquares::More, row,
      block.Guess[row] & ~(block.Must[row] | block.Passed[row]));
  }
  block.IsFull = all == ~std::uint64_t{ 0 };
  block.Guess = {};
  if (added != 0)
  {
    this->SetMark(number, GREW);
  }
}

bool lms3dRaster::HasMayOrGuess(const lms3dCellBox& box) const
{
  for (std::int32_t v = GetBlockOf(box.Bottom); v <= GetBlockOf(box.Top); ++v)
  {
    const int from = GetBlockOf(box.Bottom) == v ? GetPlaceOf(box.Bottom) : 0;
    const int to = GetBlockOf(box.Top) == v ? GetPlaceOf(box.Top) : Size - 1;
    for (std::int32_t u = GetBlockOf(box.Left); u <= GetBlockOf(box.Right); ++u)
    {
      const int number = this->Find(u, v);
      if (number < 0)
      {
        return false;
      }
      const lms3dRasterBlock& block = this->Blocks[number];
      std::uint64_t missing = 0;
      for (int row = from; !block.IsFull && row <= to; ++row)
      {
        missing |= ~(block.May[row] | block.Guess[row]);
      }
      if ((missing & GetMask(u, box.Left, box.Right)) != 0)
      {
        return false;
      }
    }
  }
  return true;
}

void lms3dRaster::MakeBlocks(const lms3dCellStrip& strip)
{
  const std::int32_t v = GetBlockOf(strip.Row);
  std::int32_t left = 1;
  std::int32_t right = 0;
  for (int row = 0; row < strip.Count; ++row)
  {
    const std::int32_t first = GetBlockOf(strip.First[row]);
    const std::int32_t last = GetBlockOf(strip.Last[row]);
    if (strip.First[row] > strip.Last[row] || (left <= first && last <= right))
    {
      continue;
    }
    for (std::int32_t u = first; u <= last; ++u)
    {
      this->Make(u, v);
    }
    left = first;
    right = last;
  }
}

void lms3dRaster::SetGuess(const lms3dCellStrip& strip)
{
  if (!this->HasBlocks(strip))
  {
    this->MakeBlocks(strip);
  }
  const std::int32_t v = GetBlockOf(strip.Row);
  for (std::int32_t u = GetBlockOf(strip.Left); !strip.IsEmpty() && u <= GetBlockOf(strip.Right);
       ++u)
  {
    const int number = this->Find(u, v);
    if (number < 0 || this->Blocks[number].IsFull)
    {
      continue;
    }
    lms3dRasterBlock& block = this->Blocks[number];
    std::uint64_t added = 0;
    for (int i = 0; i < strip.Count; ++i)
    {
      const int row = GetPlaceOf(strip.Row) + i;
      const std::uint64_t guess = strip.GetBits(i, u * Size) & ~block.May[row];
      block.Guess[row] |= guess;
      added |= guess;
    }
    if (added != 0)
    {
      this->SetMark(number, GUESSED);
      this->HasGuess = true;
    }
  }
}
