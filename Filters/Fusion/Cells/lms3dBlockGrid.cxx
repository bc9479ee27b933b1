// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dBlockGrid.h"

#include "Fusion/Cells/lms3dRaster.h"

template <typename Block>
int lms3dBlockGrid<Block>::FindOrMake(std::int32_t u, std::int32_t v)
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
  this->Link(made);
  return made;
}

template <typename Block>
bool lms3dBlockGrid<Block>::HasAny(
  BitsOf bits, std::int32_t row, std::int32_t first, std::int32_t last) const
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

template <typename Block>
bool lms3dBlockGrid<Block>::HasAny(BitsOf bits, const lms3dCellStrip& strip) const
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

template <typename Block>
bool lms3dBlockGrid<Block>::HasDifferent(
  BitsOf bits, const lms3dCellBox& box, std::uint64_t word) const
{
  for (std::int32_t v = GetBlockOf(box.Bottom); v <= GetBlockOf(box.Top); ++v)
  {
    const int from = GetBlockOf(box.Bottom) == v ? GetPlaceOf(box.Bottom) : 0;
    const int to = GetBlockOf(box.Top) == v ? GetPlaceOf(box.Top) : Size - 1;
    for (std::int32_t u = GetBlockOf(box.Left); u <= GetBlockOf(box.Right); ++u)
    {
      const int number = this->Find(u, v);
      std::uint64_t different = 0;
      for (int row = from; number >= 0 && row <= to; ++row)
      {
        different |= (this->Blocks[number].*bits)[row] ^ word;
      }
      if ((different & GetMask(u, box.Left, box.Right)) != 0)
      {
        return true;
      }
    }
  }
  return false;
}

template <typename Block>
bool lms3dBlockGrid<Block>::HasBlocks(const lms3dCellBox& box) const
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

template <typename Block>
bool lms3dBlockGrid<Block>::HasBlocks(const lms3dCellStrip& strip) const
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

template <typename Block>
void lms3dBlockGrid<Block>::Set(BitsOf bits, const lms3dCellStrip& strip, bool value)
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

template class lms3dBlockGrid<lms3dRegionBlock>;
template class lms3dBlockGrid<lms3dRasterBlock>;
