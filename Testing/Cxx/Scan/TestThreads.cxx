// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dThreads.h"

#include <tbb/parallel_for.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>

namespace
{
constexpr int Count = 1000;

int CountWork(lms3dThreads& threads, int number)
{
  std::atomic<int> done{ 0 };
  threads.Run(number, [&done] { tbb::parallel_for(0, Count, [&done](int) { ++done; }); });
  return done;
}

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

TEST(Threads, WorkAfterTheyWereWokenInAnotherNumber)
{
  lms3dThreads threads;
  EXPECT_EQ(CountWork(threads, 2), Count);
  threads.Wake(3);
  EXPECT_EQ(CountWork(threads, 2), Count);
  threads.Wake(2);
  EXPECT_EQ(CountWork(threads, 4), Count);
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
