// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dStarSides.h"

#include <algorithm>

namespace
{
constexpr std::int32_t None = -1;
} // namespace

void lms3dStarSides::AddToMany(const Side& side)
{
  if (this->Many.empty())
  {
    this->Many.assign(this->Usual.begin(), this->Usual.end());
  }
  this->Many.push_back(side);
}

// Where the side that starts at a vertex ends, or None.
std::int32_t lms3dStarSides::FindLast(std::int32_t next) const
{
  const Side* const sides = this->GetSides();
  const Side* const end = sides + this->Size;
  const Side* const found =
    std::find_if(sides, end, [next](const Side& side) { return side.Next == next; });
  return found == end ? None : found->Last;
}

bool lms3dStarSides::IsLast(std::int32_t vertex) const
{
  const Side* const sides = this->GetSides();
  return std::any_of(
    sides, sides + this->Size, [vertex](const Side& side) { return side.Last == vertex; });
}

bool lms3dStarSides::Has(std::int32_t vertex) const
{
  const Side* const sides = this->GetSides();
  return std::any_of(sides, sides + this->Size,
    [vertex](const Side& side) { return side.Next == vertex || side.Last == vertex; });
}

// Counts each vertex where a side starts or, if none does, where the first side ends.
int lms3dStarSides::CountCommon(const lms3dStarSides& other) const
{
  int common = 0;
  const Side* const sides = this->GetSides();
  for (const Side* side = sides; side != sides + this->Size; ++side)
  {
    const auto isSameStart = [side](const Side& before) { return before.Next == side->Next; };
    const auto isSameEnd = [side](const Side& before) { return before.Last == side->Last; };
    if (std::none_of(sides, side, isSameStart) && other.Has(side->Next))
    {
      ++common;
    }
    if (this->FindLast(side->Last) == None && std::none_of(sides, side, isSameEnd) &&
      other.Has(side->Last))
    {
      ++common;
    }
  }
  return common;
}

// Whether the sides lead around the vertex, once. Most stars are closed, and this is fast.
bool lms3dStarSides::IsClosed() const
{
  if (this->Difference != 0)
  {
    return false;
  }
  const std::int32_t first = this->GetSides()[this->Size - 1].Next;
  std::int32_t at = this->FindLast(first);
  std::size_t steps = 1;
  while (at != first && at != None && steps < this->Size)
  {
    at = this->FindLast(at);
    ++steps;
  }
  return at == first && steps == this->Size;
}

bool lms3dStarSides::FindBorder(lms3dStarBorder& border) const
{
  if (this->Size == 0)
  {
    border = {};
    return false;
  }
  if (this->IsClosed())
  {
    border = {};
    return true;
  }
  // The border starts at the side without one before it.
  const Side* const sides = this->GetSides();
  const Side* const end = sides + this->Size;
  const Side* const start =
    std::find_if(sides, end, [this](const Side& side) { return !this->IsLast(side.Next); });
  if (start == end)
  {
    border = {};
    return false;
  }
  std::int32_t last = start->Next;
  std::size_t steps = 0;
  for (std::int32_t at = start->Last; at != None && steps <= this->Size; at = this->FindLast(at))
  {
    last = at;
    ++steps;
  }
  border = { last, start->Next };
  return steps == this->Size;
}
