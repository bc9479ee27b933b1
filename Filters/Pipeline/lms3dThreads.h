// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The threads that a filter runs its loops with.
 */
#ifndef lms3dThreads_h
#define lms3dThreads_h

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <memory>
#include <optional>

/**
 * A TBB arena that a filter keeps from update to update.
 *
 * It takes the place of vtkSMPTools because a scan of some milliseconds consists of several
 * parallel loops. With two threads a loop costs about 2 us in an arena that exists already, and
 * about 20 us in a new one. vtkSMPTools::For costs 30 to 120 us with the STDThread backend, which
 * starts its threads again for each loop. (Debian's ParaView has this backend compiled in, but runs
 * its Sequential one unless a user or a filter changes the backend for the whole process.)
 */
class lms3dThreads
{
public:
  /// Runs `work` with `threads` threads, 0 for all cores. The calling thread takes part: it is the
  /// one that calls `work`. Throws what `work` throws.
  template <typename Work>
  void Run(int threads, const Work& work)
  {
    const int cores = tbb::info::default_concurrency();
    const int wanted = threads > 0 ? threads : cores;
    // By default TBB starts no more threads than there are cores.
    std::optional<tbb::global_control> allowance;
    if (wanted > cores)
    {
      allowance.emplace(tbb::global_control::max_allowed_parallelism, wanted);
    }
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
