// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dEchoes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

lms3dEcho lms3dEchoes::FindReported(const std::vector<double>& ranges)
{
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (double range : ranges)
  {
    // False for NaN.
    nearest = range < nearest ? range : nearest;
    farthest = range > farthest ? range : farthest;
  }
  if (farthest == 0.0)
  {
    return { std::numeric_limits<double>::quiet_NaN(), -1 };
  }
  const double start =
    this->IsInEcho(farthest, nearest) ? nearest : this->FindStartOfLargest(ranges);
  lms3dEcho echo = { 0.0, -1 };
  double excess = 0.0;
  int count = 0;
  for (std::size_t ray = 0; ray < ranges.size(); ++ray)
  {
    if (this->IsInEcho(ranges[ray], start))
    {
      excess += ranges[ray] - start;
      ++count;
      echo.Ray = echo.Ray < 0 ? static_cast<int>(ray) : echo.Ray;
    }
  }
  // The mean of the differences is 0 for equal ranges.
  echo.Range = start + excess / count;
  return echo;
}

// Returns the range of the nearest ray of the echo with the most rays.
double lms3dEchoes::FindStartOfLargest(const std::vector<double>& ranges)
{
  this->Sorted.clear();
  std::copy_if(ranges.begin(), ranges.end(), std::back_inserter(this->Sorted),
    [](double range) { return !std::isnan(range); });
  std::sort(this->Sorted.begin(), this->Sorted.end());
  double start = 0.0;
  std::ptrdiff_t largest = 0;
  for (auto first = this->Sorted.begin(); first != this->Sorted.end();)
  {
    const auto last = std::find_if_not(first, this->Sorted.end(),
      [this, first](double range) { return this->IsInEcho(range, *first); });
    if (last - first > largest)
    {
      largest = last - first;
      start = *first;
    }
    first = last;
  }
  return start;
}
