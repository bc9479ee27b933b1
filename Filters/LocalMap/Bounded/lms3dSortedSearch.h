// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Searches in sorted values, from a place that is near the result.
 */
#ifndef lms3dSortedSearch_h
#define lms3dSortedSearch_h

#include <algorithm>
#include <vector>

/**
 * Returns the number of values for which isBefore(value) is true. They come first. The search is
 * fastest if `near` is almost this number; it can be any number.
 */
template <typename Predicate>
int lms3dFindEndOf(const std::vector<double>& values, int near, const Predicate& isBefore)
{
  constexpr int Window = 4;
  constexpr int MaximumSteps = 8;
  const int size = static_cast<int>(values.size());
  if (near >= Window / 2 && near <= size - Window / 2)
  {
    const int start = near - Window / 2;
    // Without branches, which processors would predict wrongly.
    int before = 0;
    for (int i = 0; i < Window; ++i)
    {
      before += isBefore(values[start + i]) ? 1 : 0;
    }
    if (before > 0 && before < Window)
    {
      return start + before;
    }
  }
  int end = near;
  for (int step = 0; end >= 0 && end <= size && step < MaximumSteps; ++step)
  {
    if (end > 0 && !isBefore(values[end - 1]))
    {
      --end;
    }
    else if (end < size && isBefore(values[end]))
    {
      ++end;
    }
    else
    {
      return end;
    }
  }
  return static_cast<int>(
    std::partition_point(values.begin(), values.end(), isBefore) - values.begin());
}

#endif
