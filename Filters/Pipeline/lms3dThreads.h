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

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

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
    *this->IsAwaited = false;
    this->Arena->execute(work);
  }

  /// Wakes the threads of the last Run, if it had as many. They wait for the next Run, but not
  /// longer than MaximumWait. A thread that sleeps takes 50 us to wake up, which the calling thread
  /// can use for other work.
  void Wake(int threads)
  {
    const int wanted = threads > 0 ? threads : tbb::info::default_concurrency();
    if (!this->Arena || this->Arena->max_concurrency() != wanted)
    {
      return;
    }
    *this->IsAwaited = true;
    for (int i = 1; i < wanted; ++i)
    {
      this->Arena->enqueue([isAwaited = this->IsAwaited] { Wait(*isAwaited); });
    }
  }

private:
  static constexpr std::chrono::microseconds MaximumWait{ 200 };

  static void Wait(const std::atomic<bool>& isAwaited)
  {
    const auto end = std::chrono::steady_clock::now() + MaximumWait;
    while (isAwaited && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::yield();
    }
  }

  std::unique_ptr<tbb::task_arena> Arena;

  /// Whether threads wait for the next Run. They share it, since they can outlive this object.
  const std::shared_ptr<std::atomic<bool>> IsAwaited = std::make_shared<std::atomic<bool>>(false);
};

#endif
