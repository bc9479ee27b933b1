// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Loops whose bodies are so short that a thread should take several of them.
 */
#ifndef lms3dParallelTasks_h
#define lms3dParallelTasks_h

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

/// Calls work(i) for each i below `count`, with the threads of the calling TBB arena. A task makes
/// at least `minimum` calls, at least 1. Waking a thread takes some microseconds.
template <typename Work>
void lms3dForEachInTasks(std::size_t count, std::size_t minimum, const Work& work)
{
  const auto runTask = [&work](const tbb::blocked_range<std::size_t>& range)
  {
    for (std::size_t i = range.begin(); i != range.end(); ++i)
    {
      work(i);
    }
  };
  const tbb::blocked_range<std::size_t> all(0, count, minimum);
  if (count <= minimum)
  {
    runTask(all);
    return;
  }
  tbb::parallel_for(all, runTask);
}

#endif
