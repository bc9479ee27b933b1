// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRaster.h"

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
  if ((block.Region[v] & bit) != 0)
  {
    this->SetMark(number, DIRTY);
  }
  if ((block.May[v] & bit) != 0)
  {
    this->SetMark(number, DISPUTED);
  }
  if (this->HasDisputed)
  {
    this->SetMark(number, AROUND);
  }
  this->MarkReturnsBeside(number, block.U * Size + u, block.V * Size + v);
}

// Marks the blocks with returns in a cell of a block or beside it, which are not sure any more.
void lms3dRaster::MarkReturnsBeside(int number, std::int32_t u, std::int32_t v)
{
  const int left = GetPlaceOf(u) - 1;
  const int bottom = GetPlaceOf(v) - 1;
  if (left >= 0 && left < Size - 2 && bottom >= 0 && bottom < Size - 2)
  {
    const lms3dBits& must = this->Blocks[number].Must;
    if (((must[bottom] | must[bottom + 1] | must[bottom + 2]) >> left & 7U) != 0)
    {
      this->SetMark(number, DIRTY);
    }
    return;
  }
  for (std::int32_t row = v - 1; row <= v + 1; ++row)
  {
    for (std::int32_t block = GetBlockOf(u - 1); block <= GetBlockOf(u + 1); ++block)
    {
      const int other = this->Find(block, GetBlockOf(row));
      if (other >= 0 &&
        (this->Blocks[other].Must[GetPlaceOf(row)] & GetMask(block, u - 1, u + 1)) != 0)
      {
        this->SetMark(other, DIRTY);
      }
    }
  }
}

void lms3dRaster::Open(const lms3dCellStrip& strip)
{
  this->ForWords(strip,
    [this](int number, int row, std::uint64_t bits)
    {
      lms3dRasterBlock& block = this->Blocks[number];
      const std::uint64_t opened = bits & ~block.Open[row];
      block.Open[row] |= bits;
      if ((opened & block.Region[row]) != 0)
      {
        this->SetMark(number, DIRTY);
      }
      if ((opened & block.Must[row]) != 0)
      {
        this->MarkReturns(number, true);
      }
    });
}

void lms3dRaster::Forget(const lms3dCellStrip& strip)
{
  this->ForWords(strip,
    [this](int number, int row, std::uint64_t bits)
    {
      lms3dRasterBlock& block = this->Blocks[number];
      const std::uint64_t gone = bits & block.Must[row];
      block.Must[row] &= ~bits;
      if (gone != 0)
      {
        this->SetMark(number, DIRTY);
        this->MarkReturns(number, (gone & block.Open[row]) != 0);
      }
    });
}

void lms3dRaster::AcceptGuess(int number)
{
  lms3dRasterBlock& block = this->Blocks[number];
  std::uint64_t added = 0;
  std::uint64_t passed = 0;
  std::uint64_t all = ~std::uint64_t{ 0 };
  for (int row = 0; row < Size; ++row)
  {
    const std::uint64_t guess = block.Guess[row];
    added |= guess;
    passed |= guess & block.Passed[row];
    block.May[row] |= guess;
    all &= block.May[row];
  }
  block.IsFull = all == ~std::uint64_t{ 0 };
  block.Guess = {};
  if (added != 0)
  {
    this->SetMark(number, DIRTY);
    this->SetMark(number, AROUND);
  }
  if (passed != 0)
  {
    this->SetMark(number, DISPUTED);
  }
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
