// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dBlockParts.h"

#include <algorithm>
#include <cstddef>

namespace
{
// The runs that most blocks have at most.
constexpr std::size_t UsualCount = 128;

std::uint64_t GetLowest(std::uint64_t bits)
{
  return bits & (~bits + 1);
}

/// Each run has the number of an earlier run of its part, or its own.
class Links
{
public:
  Links() { this->Earlier.reserve(UsualCount); }

  int Add()
  {
    this->Earlier.push_back(static_cast<int>(this->Earlier.size()));
    return this->Earlier.back();
  }

  int FindFirst(int run)
  {
    while (this->Earlier[run] != run)
    {
      this->Earlier[run] = this->Earlier[this->Earlier[run]];
      run = this->Earlier[run];
    }
    return run;
  }

  void Connect(int a, int b)
  {
    const int first = this->FindFirst(a);
    const int second = this->FindFirst(b);
    this->Earlier[std::max(first, second)] = std::min(first, second);
  }

private:
  std::vector<int> Earlier;
};
} // namespace

lms3dBlockParts::lms3dBlockParts(const lms3dBits& cells)
{
  Links links;
  this->Runs.reserve(UsualCount);
  std::size_t below = 0;
  for (int row = 0; row < lms3dRaster::Size; ++row)
  {
    const std::size_t first = this->Runs.size();
    std::size_t other = below;
    for (std::uint64_t rest = cells[row]; rest != 0;)
    {
      // The carry of the addition goes through the lowest run.
      const std::uint64_t behind = rest + GetLowest(rest);
      const std::uint64_t bits = rest & ~behind;
      rest &= behind;
      const int run = links.Add();
      // The runs below are in order, so those that end before this run are not met again.
      while (other < first && this->Runs[other].Bits < GetLowest(bits))
      {
        ++other;
      }
      for (std::size_t i = other; i < first && GetLowest(this->Runs[i].Bits) <= bits; ++i)
      {
        if ((this->Runs[i].Bits & bits) != 0)
        {
          links.Connect(static_cast<int>(i), run);
        }
      }
      this->Runs.push_back({ bits, row, 0 });
    }
    below = first;
  }
  for (std::size_t i = 0; i < this->Runs.size(); ++i)
  {
    const int first = links.FindFirst(static_cast<int>(i));
    this->Runs[i].Part = first == static_cast<int>(i) ? this->Count++ : this->Runs[first].Part;
  }
}
