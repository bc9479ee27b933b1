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
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <new>
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
  lms3dThreads() = default;
  ~lms3dThreads() { this->EndWait(); }
  lms3dThreads(const lms3dThreads&) = delete;
  lms3dThreads& operator=(const lms3dThreads&) = delete;

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
      this->EndWait();
      this->Arena = std::make_unique<tbb::task_arena>(wanted);
    }
    this->IsAwaited = false;
    this->Arena->execute(
      [&]
      {
        work();
        this->EndWait();
      });
  }

  /// Wakes the threads of the last Run, if it had as many, and not more than there are cores. They
  /// wait for the next Run, but not longer than MaximumWait. The calling thread can do other work
  /// while they wake up. A core that waits for one filter does not work for another.
  void Wake(int threads)
  {
    this->Wake(threads, [] {});
  }

  /// Does the same. One of these threads, if there are any, first runs `preparation`, a copy. Run
  /// and EndWait wait for its end. It must not throw.
  template <typename Preparation>
  void Wake(int threads, const Preparation& preparation)
  {
    this->EndWait();
    const int cores = tbb::info::default_concurrency();
    const int wanted = threads > 0 ? threads : cores;
    if (wanted > cores || !this->Arena || this->Arena->max_concurrency() != wanted)
    {
      return;
    }
    this->IsAwaited = true;
    this->HasWaiting = true;
    this->TimeOfWake = std::chrono::steady_clock::now();
    this->Arena->execute([&] { this->StartWaiting(wanted - 1, preparation); });
  }

  /// Ends the wait of the threads that were woken. The calling thread takes part in a preparation.
  void EndWait()
  {
    this->IsAwaited = false;
    if (this->HasWaiting)
    {
      this->Arena->execute([this] { this->Waiting.wait(); });
      this->HasWaiting = false;
    }
  }

  /// Returns whether the last Wake was less than MaximumWait ago, or its preparation has not ended,
  /// and no Run came after it.
  bool AreAwake() const
  {
    const auto end = this->TimeOfWake + MaximumWait;
    return this->IsAwaited && (this->IsPreparing || std::chrono::steady_clock::now() < end);
  }

  /// How many threads wait for a Run at this moment.
  int GetNumberOfWaiting() const { return this->NumberOfWaiting; }

private:
  static constexpr std::chrono::microseconds MaximumWait{ 200 };

  template <typename Preparation>
  void StartWaiting(int threads, const Preparation& preparation)
  {
    try
    {
      this->IsPreparing = threads > 0;
      for (int i = 0; i < threads; ++i)
      {
        this->Waiting.run(
          [this, i, preparation]
          {
            if (i == 0)
            {
              // Otherwise this thread could take a task that waits before the preparation ends.
              tbb::this_task_arena::isolate(preparation);
              this->IsPreparing = false;
            }
            this->Wait();
          });
      }
    }
    catch (const std::bad_alloc&)
    {
      // Run() needs no thread that waits.
      this->IsAwaited = false;
      this->IsPreparing = false;
    }
  }

  void Wait()
  {
    ++this->NumberOfWaiting;
    const auto end = std::chrono::steady_clock::now() + MaximumWait;
    while (this->IsAwaited && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::yield();
    }
    --this->NumberOfWaiting;
  }

  std::unique_ptr<tbb::task_arena> Arena;

  /// Whether threads wait for the next Run, and how many.
  std::atomic<bool> IsAwaited{ false };
  std::atomic<int> NumberOfWaiting{ 0 };

  ///@{
  /// The last Wake, and whether its preparation has not ended.
  std::atomic<bool> IsPreparing{ false };
  std::chrono::steady_clock::time_point TimeOfWake;
  ///@}

  ///@{
  /// One task for each thread that waits, and whether there can be some.
  tbb::task_group Waiting;
  bool HasWaiting = false;
  ///@}
};

#endif
