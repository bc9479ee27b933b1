// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Work for the threads of a filter, and how much of it they did.
 */
#ifndef ThreadWork_h
#define ThreadWork_h

#include "Pipeline/lms3dThreads.h"

#include <tbb/parallel_for.h>

#include <atomic>

constexpr int Count = 1000;

/// Returns how many of Count tasks were done.
inline int CountWork(lms3dThreads& threads, int number)
{
  std::atomic<int> done{ 0 };
  threads.Run(number, [&done] { tbb::parallel_for(0, Count, [&done](int) { ++done; }); });
  return done;
}

#endif
