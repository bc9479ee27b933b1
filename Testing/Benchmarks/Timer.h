// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Wall time, the best of many runs.
 */
#ifndef Timer_h
#define Timer_h

#include <algorithm>
#include <chrono>
#include <limits>

template <typename Work>
double GetMilliseconds(const Work& work)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Repeats the work until the budget (ms) is spent, but at least once; the best time counts, since
/// other work on the machine can only add to it.
template <typename Work>
double GetBestMilliseconds(double budget, const Work& work)
{
  double best = std::numeric_limits<double>::infinity();
  for (double spent = 0.0; spent < budget || spent == 0.0;)
  {
    const double ms = GetMilliseconds(work);
    best = std::min(best, ms);
    spent += ms;
  }
  return best;
}

#endif
