// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRaster.h"

int lms3dRaster::Make(std::int32_t u, std::int32_t v)
{
  const auto [place, isNew] = this->Numbers.try_emplace(GetKey(u, v), this->GetNumberOfBlocks());
  if (isNew)
  {
    lms3dRasterBlock block;
    block.U = u;
    block.V = v;
    this->Blocks.push_back(block);
  }
  return place->second;
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

bool lms3dRaster::HasBlocks(std::int32_t row, std::int32_t first, std::int32_t last) const
{
  for (std::int32_t u = GetBlockOf(first); u <= GetBlockOf(last); ++u)
  {
    if (this->Find(u, GetBlockOf(row)) < 0)
    {
      return false;
    }
  }
  return true;
}
