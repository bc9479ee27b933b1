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

void lms3dRaster::SetAndMark(BitsOf bits, const lms3dCellStrip& strip, bool value)
{
  const std::int32_t v = GetBlockOf(strip.Row);
  for (std::int32_t u = GetBlockOf(strip.Left); !strip.IsEmpty() && u <= GetBlockOf(strip.Right);
       ++u)
  {
    const int number = this->Find(u, v);
    if (number < 0)
    {
      continue;
    }
    std::uint64_t* words = &(this->Blocks[number].*bits)[GetPlaceOf(strip.Row)];
    const std::uint64_t* shape = &this->Blocks[number].Shape[GetPlaceOf(strip.Row)];
    std::uint64_t changed = 0;
    for (int row = 0; row < strip.Count; ++row)
    {
      const std::uint64_t mask = strip.GetBits(row, u * Size);
      const std::uint64_t set = value ? words[row] | mask : words[row] & ~mask;
      changed |= (set ^ words[row]) & shape[row];
      words[row] = set;
    }
    if (changed != 0)
    {
      this->SetMark(number, DIRTY);
    }
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
  this->MakeBlocks(strip);
  const std::int32_t v = GetBlockOf(strip.Row);
  for (std::int32_t u = GetBlockOf(strip.Left); !strip.IsEmpty() && u <= GetBlockOf(strip.Right);
       ++u)
  {
    const int number = this->Find(u, v);
    if (number >= 0)
    {
      this->SetMark(number, GUESSED);
    }
  }
  this->Set(&lms3dRasterBlock::Guess, strip, true);
}
