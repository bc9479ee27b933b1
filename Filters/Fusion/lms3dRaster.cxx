// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRaster.h"

int lms3dRaster::FindOrMake(std::int32_t u, std::int32_t v)
{
  const int found = this->Numbers.Find(u, v);
  if (found >= 0)
  {
    return found;
  }
  const int made = this->GetNumberOfBlocks();
  this->Numbers.Add(u, v, made);
  this->Blocks.emplace_back();
  this->Blocks.back().U = u;
  this->Blocks.back().V = v;
  return made;
}

void lms3dRaster::ClearMarks()
{
  for (const int number : this->Marked)
  {
    this->Blocks[number].Marks = 0;
  }
  this->Marked.clear();
}

bool lms3dRaster::Has(BitsOf bits, std::int32_t u, std::int32_t v) const
{
  const int number = this->Find(GetBlockOf(u), GetBlockOf(v));
  return number >= 0 && ((this->Blocks[number].*bits)[GetPlaceOf(v)] >> GetPlaceOf(u) & 1U) != 0;
}

bool lms3dRaster::HasAny(BitsOf bits, std::int32_t row, std::int32_t first, std::int32_t last) const
{
  for (std::int32_t u = GetBlockOf(first); u <= GetBlockOf(last); ++u)
  {
    const int number = this->Find(u, GetBlockOf(row));
    if (number >= 0 &&
      ((this->Blocks[number].*bits)[GetPlaceOf(row)] & GetMask(u, first, last)) != 0)
    {
      return true;
    }
  }
  return false;
}

bool lms3dRaster::HasAny(BitsOf bits, const lms3dCellStrip& strip) const
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
    const std::uint64_t* words = &(this->Blocks[number].*bits)[GetPlaceOf(strip.Row)];
    std::uint64_t found = 0;
    for (int row = 0; row < strip.Count; ++row)
    {
      found |= words[row] & strip.GetBits(row, u * Size);
    }
    if (found != 0)
    {
      return true;
    }
  }
  return false;
}

bool lms3dRaster::HasAny(BitsOf bits, const lms3dCellBox& box) const
{
  for (std::int32_t v = GetBlockOf(box.Bottom); v <= GetBlockOf(box.Top); ++v)
  {
    const int from = GetBlockOf(box.Bottom) == v ? GetPlaceOf(box.Bottom) : 0;
    const int to = GetBlockOf(box.Top) == v ? GetPlaceOf(box.Top) : Size - 1;
    for (std::int32_t u = GetBlockOf(box.Left); u <= GetBlockOf(box.Right); ++u)
    {
      const int number = this->Find(u, v);
      std::uint64_t found = 0;
      for (int row = from; number >= 0 && row <= to; ++row)
      {
        found |= (this->Blocks[number].*bits)[row];
      }
      if ((found & GetMask(u, box.Left, box.Right)) != 0)
      {
        return true;
      }
    }
  }
  return false;
}

bool lms3dRaster::HasAll(BitsOf bits, const lms3dCellBox& box) const
{
  for (std::int32_t v = GetBlockOf(box.Bottom); v <= GetBlockOf(box.Top); ++v)
  {
    const int from = GetBlockOf(box.Bottom) == v ? GetPlaceOf(box.Bottom) : 0;
    const int to = GetBlockOf(box.Top) == v ? GetPlaceOf(box.Top) : Size - 1;
    for (std::int32_t u = GetBlockOf(box.Left); u <= GetBlockOf(box.Right); ++u)
    {
      const int number = this->Find(u, v);
      std::uint64_t missing = 0;
      for (int row = from; number >= 0 && row <= to; ++row)
      {
        missing |= ~(this->Blocks[number].*bits)[row];
      }
      if ((missing & GetMask(u, box.Left, box.Right)) != 0)
      {
        return false;
      }
    }
  }
  return true;
}

bool lms3dRaster::HasBlocks(const lms3dCellBox& box) const
{
  for (std::int32_t v = GetBlockOf(box.Bottom); v <= GetBlockOf(box.Top); ++v)
  {
    for (std::int32_t u = GetBlockOf(box.Left); u <= GetBlockOf(box.Right); ++u)
    {
      if (this->Find(u, v) < 0)
      {
        return false;
      }
    }
  }
  return true;
}

bool lms3dRaster::HasBlocks(const lms3dCellStrip& strip) const
{
  const std::int32_t v = GetBlockOf(strip.Row);
  for (std::int32_t u = GetBlockOf(strip.Left); !strip.IsEmpty() && u <= GetBlockOf(strip.Right);
       ++u)
  {
    for (int row = 0; row < strip.Count && this->Find(u, v) < 0; ++row)
    {
      if (strip.GetBits(row, u * Size) != 0)
      {
        return false;
      }
    }
  }
  return true;
}

void lms3dRaster::Set(BitsOf bits, const lms3dCellStrip& strip, bool value)
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
    for (int row = 0; row < strip.Count; ++row)
    {
      const std::uint64_t mask = strip.GetBits(row, u * Size);
      words[row] = value ? words[row] | mask : words[row] & ~mask;
    }
  }
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
