// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dThreads.h"
#include "Scan/ThreadWork.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>

namespace
{
void Sleep()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}
} // namespace

TEST(Threads, DoAllWorkAfterTheyWereWoken)
{
  lms3dThreads threads;
  for (int number : { 1, 2, 3, 8, 0 })
  {
    threads.Wake(number);
    for (int i = 0; i < 100; ++i)
    {
      ASSERT_EQ(CountWork(threads, number), Count) << number << " threads";
      threads.Wake(number);
      threads.Wake(number);
    }
  }
}

TEST(Threads, WaitForWorkAfterTheyWereWoken)
{
  if (tbb::info::default_concurrency() < 2)
  {
    GTEST_SKIP() << "one core: no other thread to wake";
  }
  lms3dThreads threads;
  CountWork(threads, 2);
  // On a busy machine, this thread can miss the wait of the other one, even if that one is awake.
  bool hasWaited = false;
  for (int attempt = 0; attempt < 1000 && !hasWaited; ++attempt)
  {
    std::atomic<bool> isAwake{ false };
    std::atomic<bool> mayWait{ false };
    threads.Wake(2,
      [&]
      {
        isAwake = true;
        while (!mayWait)
        {
          std::this_thread::yield();
        }
      });
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    while (!hasWaited && std::chrono::steady_clock::now() < end)
    {
      mayWait = isAwake.load();
      hasWaited = threads.GetNumberOfWaiting() == 1;
    }
    mayWait = true;
    threads.EndWait();
  }
  EXPECT_TRUE(hasWaited);
  EXPECT_EQ(CountWork(threads, 2), Count);
  EXPECT_EQ(threads.GetNumberOfWaiting(), 0);
}

TEST(Threads, EndTheirWaitIfTheyAreWokenAgainAndAgain)
{
  lms3dThreads threads;
  CountWork(threads, 2);
  for (int i = 0; i < 1000; ++i)
  {
    threads.Wake(2);
  }
  // 1,000 waits of 0.2 ms would take as much.
  const std::clock_t start = std::clock();
  Sleep();
  Sleep();
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 0.1);
}

TEST(Threads, WorkAfterTheyWereWokenInAnotherNumber)
{
  lms3dThreads threads;
  EXPECT_EQ(CountWork(threads, 2), Count);
  threads.Wake(3);
  EXPECT_EQ(CountWork(threads, 2), Count);
  threads.Wake(2);
  EXPECT_EQ(CountWork(threads, 4), Count);
}

TEST(Threads, RunAPreparationOnceBeforeTheWaitEnds)
{
  for (int number : { 1, 2, 4 })
  {
    lms3dThreads threads;
    CountWork(threads, number);
    const bool isPrepared = number > 1 && number <= tbb::info::default_concurrency();
    for (int i = 0; i < 100; ++i)
    {
      std::atomic<int> done{ 0 };
      const auto prepare = [&done] { tbb::parallel_for(0, Count, [&done](int) { ++done; }); };
      threads.Wake(number, prepare);
      if (i % 2 == 0)
      {
        threads.EndWait();
      }
      else
      {
        CountWork(threads, number);
      }
      ASSERT_EQ(done, isPrepared ? Count : 0) << number << " threads";
    }
  }
}

TEST(Threads, AreAwakeUntilThePreparationEnds)
{
  if (tbb::info::default_concurrency() < 2)
  {
    GTEST_SKIP() << "one core: no other thread to wake";
  }
  lms3dThreads threads;
  CountWork(threads, 2);
  std::atomic<bool> mayEnd{ false };
  threads.Wake(2,
    [&mayEnd]
    {
      while (!mayEnd)
      {
        std::this_thread::yield();
      }
    });
  Sleep();
  EXPECT_TRUE(threads.AreAwake());
  mayEnd = true;
  threads.EndWait();
  EXPECT_FALSE(threads.AreAwake());
}

TEST(Threads, AreAwakeForAShortTime)
{
  lms3dThreads threads;
  EXPECT_FALSE(threads.AreAwake());
  CountWork(threads, 1);
  bool wereAwake = false;
  for (int attempt = 0; attempt < 1000 && !wereAwake; ++attempt)
  {
    threads.Wake(1);
    wereAwake = threads.AreAwake();
  }
  EXPECT_TRUE(wereAwake);
  Sleep();
  EXPECT_FALSE(threads.AreAwake());
  threads.Wake(1);
  threads.EndWait();
  EXPECT_FALSE(threads.AreAwake());
}

TEST(Threads, WorkAfterAnException)
{
  lms3dThreads threads;
  EXPECT_THROW(threads.Run(2, [] { throw std::runtime_error("stopped"); }), std::runtime_error);
  threads.Wake(2);
  EXPECT_EQ(CountWork(threads, 2), Count);
}

TEST(Threads, EndTheirWaitIfNoWorkFollows)
{
  lms3dThreads threads;
  CountWork(threads, 2);
  threads.Wake(2);
  Sleep();
  const std::clock_t start = std::clock();
  Sleep();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 0.05);
  EXPECT_EQ(CountWork(threads, 2), Count);
}

TEST(Threads, EndTheirWaitWithTheirOwner)
{
  for (int i = 0; i < 100; ++i)
  {
    lms3dThreads threads;
    CountWork(threads, 2);
    threads.Wake(2);
  }
}
