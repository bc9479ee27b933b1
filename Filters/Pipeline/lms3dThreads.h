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

#include <unistd.h>

/**
 * A TBB arena that a filter keeps from update to update.
 *
 * It takes the place of vtkSMPTools because a scan of some milliseconds consists of several
 * parallel loops. With two threads a loop costs about 2 us in an arena that exists already, and
 * about 20 us in a new one. vtkSMPTools::For costs 30 to 120 us with the STDThread backend, which
 * starts its threads again for each loop. (Debian's ParaView has this backend compiled in, but runs
 * its Sequential one unless a user or a filter changes the backend for the whole process.)
 *
 * A child of fork() has none of the threads that its parent woke, and can use the object like one
 * whose threads were not woken.
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
    if (!this->Arena || this->Arena->max_concurrency() != wanted || this->IsForked())
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

  /// Does the same. One of these threads, if there are any, first runs `preparation`, a copy, which
  /// must not throw. EndWait waits for its end, or runs it. Run waits only after `work`: call
  /// EndWait before if `work` needs what the preparation makes, or uses what it uses.
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
    this->WakingProcess = getpid();
    this->TimeOfWake = std::chrono::steady_clock::now();
    this->Arena->execute([&] { this->StartWaiting(wanted - 1, preparation); });
  }

  /// Ends the wait of the threads that were woken. The calling thread takes part in a preparation.
  /// Returns false if another process woke them: a preparation may then be half done.
  bool EndWait()
  {
    this->IsAwaited = false;
    if (this->IsForked())
    {
      this->Abandon();
      return false;
    }
    if (this->Waiting)
    {
      this->Arena->execute([this] { this->Waiting->wait(); });
      this->Waiting = nullptr;
    }
    return true;
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
      this->Waiting = std::make_unique<tbb::task_group>();
      this->IsPreparing = threads > 0;
      if (threads > 0)
      {
        this->Waiting->run(
          [this, preparation]
          {
            // Otherwise this thread could take a task that waits before the preparation ends.
            tbb::this_task_arena::isolate(preparation);
            this->IsPreparing = false;
            this->Wait();
          });
      }
      for (int i = 1; i < threads; ++i)
      {
        this->Waiting->run([this] { this->Wait(); });
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

  bool IsForked() const { return this->Waiting && this->WakingProcess != getpid(); }

  // The destructors would wait for threads that do not exist.
  void Abandon()
  {
    [[maybe_unused]] const tbb::task_group* waiting = this->Waiting.release();
    [[maybe_unused]] const tbb::task_arena* arena = this->Arena.release();
    this->NumberOfWaiting = 0;
    this->IsPreparing = false;
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
  /// One task for each thread that waits, null if there can be none, and the process that woke
  /// them.
  std::unique_ptr<tbb::task_group> Waiting;
  pid_t WakingProcess = 0;
  ///@}
};

#endif
