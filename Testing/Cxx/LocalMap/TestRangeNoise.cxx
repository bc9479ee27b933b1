// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that the estimated noise of a scan does not depend on the number of threads.
 */
#include "Fixtures/VectorFixtures.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <vtkMath.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <thread>
#include <vector>

namespace
{
constexpr int Beams = 361;
constexpr int Turns = 720;
constexpr double Alpha[2] = { -90.0, 90.0 };
constexpr double Beta[2] = { 0.0, 360.0 };
/// The inverse of such a range, metres, is infinite.
constexpr double TinyRange = 1e-310;

/// Metres.
constexpr double Sigma = 0.01;

/// Normally distributed, with a standard deviation of 1.
double GetNormal(Random& random)
{
  const double length = std::sqrt(-2.0 * std::log(1.0 - random.Get()));
  return length * std::cos(2.0 * vtkMath::Pi() * random.Get());
}

/// A ball with noise. A share of its ranges is tiny.
struct NoisyBall
{
  explicit NoisyBall(double shareOfTiny)
  {
    Random random(5);
    std::vector<double> ranges(static_cast<std::size_t>(Beams) * Turns);
    for (double& range : ranges)
    {
      const double noisy = 2.0 + Sigma * GetNormal(random);
      range = random.Get() < shareOfTiny ? TinyRange : noisy;
    }
    std::vector<int> ids(ranges.size());
    std::iota(ids.begin(), ids.end(), 0);
    this->Grid.Build(this->Geometry, ranges.data(), ids.data(), Beams * Turns);
    this->Joins.Find(this->Grid, 0.1);
  }

  const lms3dScanGeometry Geometry{ Alpha, Beams, Beta, Turns };
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
};

/// Waits up to a second until a number of threads work in the arena.
void GatherThreads(int threads)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  std::atomic<int> arrived{ 0 };
  tbb::parallel_for(
    0, threads, 1,
    [&](int)
    {
      ++arrived;
      while (arrived < threads && std::chrono::steady_clock::now() < end)
      {
        std::this_thread::yield();
      }
    },
    tbb::simple_partitioner());
}

/// The bits of the noise that some threads estimate.
std::uint64_t Estimate(const lms3dBeamSphere& sphere, int threads)
{
  const double noise = tbb::task_arena(threads).execute(
    [&]
    {
      GatherThreads(threads);
      return lms3dEstimateNoise(sphere);
    });
  std::uint64_t bits = 0;
  std::memcpy(&bits, &noise, sizeof(bits));
  return bits;
}
} // namespace

// Tiny ranges make residuals that are infinite or no numbers. Then the median depends on their
// order.
TEST(RangeNoise, IsTheSameForAnyNumberOfThreads)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  for (double share : { 0.0, 0.2 })
  {
    const NoisyBall ball(share);
    const lms3dBeamSphere sphere(ball.Grid, ball.Joins);
    const std::uint64_t expected = Estimate(sphere, 1);
    for (int run = 0; run < 10; ++run)
    {
      EXPECT_EQ(Estimate(sphere, 2), expected) << share;
      EXPECT_EQ(Estimate(sphere, 8), expected) << share;
    }
  }
}

TEST(RangeNoise, IsNearTheStandardDeviation)
{
  const NoisyBall ball(0.0);
  const lms3dBeamSphere sphere(ball.Grid, ball.Joins);
  EXPECT_NEAR(lms3dEstimateNoise(sphere), Sigma, 0.04 * Sigma);
}
