// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A process that was forked does not wait for the threads that its parent woke.
 */
#include "Pipeline/lms3dThreads.h"
#include "Scan/ThreadWork.h"

#include <tbb/info.h>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
// Forks while a thread runs a preparation. Returns what waitpid says of the child, which exits with
// 0 if `work` returns true, and is killed if it hangs.
template <typename Work>
int RunInChild(lms3dThreads& threads, const Work& work)
{
  std::atomic<bool> isBegun{ false };
  std::atomic<bool> mayEnd{ false };
  threads.Wake(2,
    [&]
    {
      isBegun = true;
      while (!mayEnd)
      {
        std::this_thread::yield();
      }
    });
  while (!isBegun)
  {
    std::this_thread::yield();
  }
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(20);
    _exit(work() ? 0 : 1);
  }
  mayEnd = true;
  // The preparation uses this function's variables.
  threads.EndWait();
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}
} // namespace

TEST(ForkedThreads, WorkInAChildOfTheProcessThatWokeThem)
{
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer does not follow a fork of several threads";
#endif
  if (tbb::info::default_concurrency() < 2)
  {
    GTEST_SKIP() << "one core: no other thread to wake";
  }
  auto threads = std::make_unique<lms3dThreads>();
  CountWork(*threads, 2);
  EXPECT_EQ(RunInChild(*threads, [&] { return CountWork(*threads, 2) == Count; }), 0);
  EXPECT_EQ(CountWork(*threads, 2), Count);
  const auto endWait = [&]
  {
    const bool isLeft = !threads->EndWait() && !threads->AreAwake();
    return isLeft && threads->EndWait() && CountWork(*threads, 2) == Count;
  };
  EXPECT_EQ(RunInChild(*threads, endWait), 0);
  EXPECT_TRUE(threads->EndWait());
  const auto destroy = [&]
  {
    threads = nullptr;
    return true;
  };
  EXPECT_EQ(RunInChild(*threads, destroy), 0);
}
