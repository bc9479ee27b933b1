// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The laws that errors of ranges obey. Statistics are within four standard errors.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Sigma = 0.005;

/// The errors of 129,960 returns from a ball, for different properties.
class LMS3DRangeErrorLaws : public ::testing::Test
{
protected:
  LMS3DRangeErrorLaws()
    : Pipeline(MakeBall(4.0))
  {
    this->Pipeline.Errors->SetRangeNoise(Sigma);
    this->Pipeline.Errors->SetNoiseSeed(1);
  }

  std::vector<double> GetErrors() { return this->Pipeline.GetErrors(); }

  RangeErrorPipeline Pipeline;
};

// The largest distance between the distribution of the values and the normal distribution.
double GetDistanceFromNormal(std::vector<double> values, double sigma)
{
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double share = 0.5 * std::erfc(-values[i] / (sigma * std::sqrt(2.0)));
    distance =
      std::max({ distance, share - static_cast<double>(i) / count, (i + 1.0) / count - share });
  }
  return distance;
}
} // namespace

TEST_F(LMS3DRangeErrorLaws, NoiseHasMeanZeroAndItsStandardDeviation)
{
  for (int seed : { 0, 1, -1, 20061 })
  {
    this->Pipeline.Errors->SetNoiseSeed(seed);
    const Moments errors(this->GetErrors());
    ASSERT_EQ(errors.Count, 361 * 360);
    EXPECT_LT(std::abs(errors.Mean), 4.0 * Sigma / std::sqrt(errors.Count)) << seed;
    EXPECT_LT(std::abs(errors.Variance - Sigma * Sigma),
      4.0 * Sigma * Sigma * std::sqrt(2.0 / errors.Count))
      << seed;
  }
}

TEST_F(LMS3DRangeErrorLaws, NoiseIsNormallyDistributed)
{
  const std::vector<double> errors = this->GetErrors();
  const Moments moments(errors);
  EXPECT_LT(std::abs(moments.Skewness), 4.0 * std::sqrt(6.0 / moments.Count));
  EXPECT_LT(std::abs(moments.Kurtosis - 3.0), 4.0 * std::sqrt(24.0 / moments.Count));
  // The test of Kolmogorov and Smirnov, at a level of one in a thousand.
  EXPECT_LT(GetDistanceFromNormal(errors, Sigma), 1.95 / std::sqrt(moments.Count));
  // The largest of 130,000 normal deviates is 4.4 on average.
  const auto extremes = std::minmax_element(errors.begin(), errors.end());
  EXPECT_LT(*extremes.first, -3.8 * Sigma);
  EXPECT_GT(*extremes.second, 3.8 * Sigma);
}

TEST_F(LMS3DRangeErrorLaws, NoiseOfNeighboursIsIndependent)
{
  const std::vector<double> errors = this->GetErrors();
  const double bound = 4.0 / std::sqrt(static_cast<double>(errors.size()));
  // Neighbours in the fan, in one draw and in two; neighbours in turns.
  for (std::size_t lag : { 1, 2, 3, 360, 361, 362, 722 })
  {
    EXPECT_LT(std::abs(GetCorrelation(errors, lag)), bound) << lag;
  }
  // Sine and cosine of one draw have no correlation, but squares must have none either.
  std::vector<double> squares(errors);
  std::for_each(squares.begin(), squares.end(), [](double& x) { x *= x; });
  for (std::size_t lag : { 1, 2, 361 })
  {
    EXPECT_LT(std::abs(GetCorrelation(squares, lag)), bound) << lag;
  }
}

TEST_F(LMS3DRangeErrorLaws, NoiseOfTwoSeedsIsIndependent)
{
  const std::vector<double> first = this->GetErrors();
  const double bound = 4.0 / std::sqrt(static_cast<double>(first.size()));
  for (int seed : { 0, 2, -1, 1 << 30 })
  {
    this->Pipeline.Errors->SetNoiseSeed(seed);
    EXPECT_LT(std::abs(GetCorrelation(first, this->GetErrors())), bound) << seed;
  }
}

TEST_F(LMS3DRangeErrorLaws, NoiseIsProportionalToItsStandardDeviation)
{
  const std::vector<double> errors = this->GetErrors();
  this->Pipeline.Errors->SetRangeNoise(2.0 * Sigma);
  const std::vector<double> twice = this->GetErrors();
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    ASSERT_NEAR(twice[i], 2.0 * errors[i], 4e-15) << i;
  }
}

TEST_F(LMS3DRangeErrorLaws, BiasIsAddedToEveryRange)
{
  this->Pipeline.Errors->SetRangeNoise(0.0);
  for (double bias : { 0.015, -0.04, 1e-9 })
  {
    this->Pipeline.Errors->SetRangeBias(bias);
    this->Pipeline.Run();
    const std::vector<double> truth = GetRanges(this->Pipeline.Scan->GetOutput());
    const std::vector<double> reported = GetRanges(this->Pipeline.Errors->GetOutput());
    ASSERT_EQ(reported.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      ASSERT_EQ(reported[i], truth[i] + bias) << i;
    }
  }
}

TEST_F(LMS3DRangeErrorLaws, ResolutionTakesTheNearestMultiple)
{
  this->Pipeline.Errors->SetRangeNoise(0.0);
  for (double step : { 0.001, 0.01, 0.0094, 1.5, 1e-15, 1e-320 })
  {
    this->Pipeline.Errors->SetRangeResolution(step);
    const std::vector<double> errors = this->GetErrors();
    const std::vector<double> reported = GetRanges(this->Pipeline.Errors->GetOutput());
    ASSERT_FALSE(errors.empty());
    for (std::size_t i = 0; i < errors.size(); ++i)
    {
      ASSERT_LE(std::abs(errors[i]), 0.5 * step + 1e-15) << i;
      const double steps = reported[i] / step;
      ASSERT_TRUE(steps > 0x1p51 || std::abs(steps - std::round(steps)) <= 4e-16 * steps) << i;
    }
  }
}

TEST_F(LMS3DRangeErrorLaws, ResolutionGivesTheDoubleNearestToTheDecimalNumber)
{
  this->Pipeline.Errors->SetRangeResolution(0.001);
  this->Pipeline.Run();
  for (double range : GetRanges(this->Pipeline.Errors->GetOutput()))
  {
    ASSERT_EQ(range, std::round(1000.0 * range) / 1000.0);
  }
}

TEST_F(LMS3DRangeErrorLaws, ResolutionErrorOfATiltedWallIsUniform)
{
  constexpr double Step = 0.01;
  RangeErrorPipeline wall(MakePolygon({ { 2, -4, -3 }, { 5, 4, -3 }, { 5, 4, 3 }, { 2, -4, 3 } }));
  wall.Errors->SetRangeResolution(Step);
  const Moments errors(wall.GetErrors());
  ASSERT_GT(errors.Count, 10000);
  const double variance = Step * Step / 12.0;
  EXPECT_LT(std::abs(errors.Mean), 4.0 * std::sqrt(variance / errors.Count));
  // A uniform distribution has a kurtosis of 1.8.
  EXPECT_LT(std::abs(errors.Variance - variance), 4.0 * variance * std::sqrt(0.8 / errors.Count));
}

TEST_F(LMS3DRangeErrorLaws, OneErrorChangesNoDrawOfAnother)
{
  constexpr double Step = 0.01;
  constexpr double Bias = 0.0123;
  this->Pipeline.Run();
  const std::vector<double> noisy = GetRanges(this->Pipeline.Errors->GetOutput());
  const std::vector<double> truth = GetRanges(this->Pipeline.Scan->GetOutput());
  this->Pipeline.Errors->SetRangeResolution(Step);
  this->Pipeline.Run();
  const std::vector<double> rounded = GetRanges(this->Pipeline.Errors->GetOutput());
  this->Pipeline.Errors->SetRangeBias(Bias);
  this->Pipeline.Errors->SetRangeResolution(0.0);
  this->Pipeline.Run();
  const std::vector<double> biased = GetRanges(this->Pipeline.Errors->GetOutput());
  this->Pipeline.Errors->SetRangeResolution(Step);
  this->Pipeline.Run();
  const std::vector<double> all = GetRanges(this->Pipeline.Errors->GetOutput());
  ASSERT_EQ(all.size(), truth.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    ASSERT_EQ(rounded[i], std::round(noisy[i] * 100.0) / 100.0) << i;
    ASSERT_NEAR(biased[i] - noisy[i], Bias, 4e-15) << i;
    // Bias and noise come before the resolution.
    ASSERT_EQ(all[i], std::round(biased[i] * 100.0) / 100.0) << i;
  }
}
