// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The threads of a filter.
 */
#ifndef lms3dThreads_h
#define lms3dThreads_h

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

/// Threads are slow to join a new TBB arena, so a filter keeps its own from run to run.
class lms3dThreads
{
public:
  /// Does the work with so many threads, 0 for all cores; throws what the work throws.
  template <typename Work>
  void Run(int threads, const Work& work)
  {
    const int cores = tbb::info::default_concurrency();
    const int wanted = threads > 0 ? threads : cores;
    // TBB makes no more threads than there are cores unless it is allowed to.
    const tbb::global_control allowance(
      tbb::global_control::max_allowed_parallelism, std::max(wanted, cores));
    if (!this->Arena || this->Arena->max_concurrency() != wanted)
    {
      this->Arena = std::make_unique<tbb::task_arena>(wanted);
    }
    this->Arena->execute(work);
  }

private:
  std::unique_ptr<tbb::task_arena> Arena;
};

#endif
