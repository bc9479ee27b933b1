// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The random numbers of all instruction sets, against the C library's functions.
 */
#include "Kernels/lms3dPacketKernels.h"

#include <Random123/threefry.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
constexpr int Pairs = 1001; // no multiple of a vector's length

std::vector<double> Draw(const lms3dPacketKernels& kernels, const lms3dDrawKey& key)
{
  std::vector<double> deviates(2 * Pairs);
  kernels.DrawNormals(key, Pairs, deviates.data());
  return deviates;
}

const std::vector<lms3dDrawKey> Keys = { { 0, 0, lms3dEffect::RANGE_NOISE, 0 },
  { 1, 0, lms3dEffect::RANGE_NOISE, 0 }, { 0, 1, lms3dEffect::RANGE_NOISE, 0 },
  { 0, 0, lms3dEffect::RANGE_NOISE, 1 }, { 0, 0, static_cast<lms3dEffect>(2), 0 },
  { ~0u, ~0ull, lms3dEffect::RANGE_NOISE, ~0u } };
} // namespace

TEST(RangeErrorKernels, DrawTheSameBitsWithAllInstructionSets)
{
  for (const lms3dDrawKey& key : Keys)
  {
    const std::vector<double> expected = Draw(lms3dGetPacketKernels(0), key);
    for (int i = 1; i < lms3dGetNumberOfPacketKernels(); ++i)
    {
      const std::vector<double> found = Draw(lms3dGetPacketKernels(i), key);
      EXPECT_EQ(std::memcmp(found.data(), expected.data(), sizeof(double) * expected.size()), 0)
        << lms3dGetPacketKernels(i).Name;
    }
  }
}

TEST(RangeErrorKernels, DrawOtherNumbersForEachPartOfTheKey)
{
  for (std::size_t i = 0; i < Keys.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      const std::vector<double> one = Draw(lms3dGetPacketKernels(), Keys[i]);
      const std::vector<double> other = Draw(lms3dGetPacketKernels(), Keys[k]);
      for (int n = 0; n < 2 * Pairs; ++n)
      {
        ASSERT_NE(one[n], other[n]) << i << ' ' << k << ' ' << n;
      }
    }
  }
}

TEST(RangeErrorKernels, DrawTheTransformOfBoxAndMuller)
{
  constexpr double QuarterTurn = 1.5707963267948966;
  for (const lms3dDrawKey& key : Keys)
  {
    const std::vector<double> deviates = Draw(lms3dGetPacketKernels(), key);
    for (int pair = 0; pair < Pairs; ++pair)
    {
      const threefry2x64_ctr_t counter = { { static_cast<std::uint64_t>(key.Effect) << 32 |
          key.Turn,
        static_cast<std::uint64_t>(pair) } };
      const threefry2x64_key_t cipherKey = { { key.Seed, key.Scan } };
      const threefry2x64_ctr_t random = threefry2x64(counter, cipherKey);
      const double uniform = 1.0 - static_cast<double>(random.v[0] >> 12) * 0x1p-52;
      const double radius = std::sqrt(-2.0 * std::log(uniform));
      const double angle = (static_cast<double>(random.v[1] >> 12) * 0x1p-52 - 0.5) * QuarterTurn;
      const double sign = random.v[1] & 2u ? -1.0 : 1.0;
      const bool isSwapped = random.v[1] & 1u;
      EXPECT_NEAR(deviates[2 * pair + (isSwapped ? 1 : 0)], sign * radius * std::cos(angle), 4e-15);
      EXPECT_NEAR(deviates[2 * pair + (isSwapped ? 0 : 1)], sign * radius * std::sin(angle), 4e-15);
    }
  }
}

// Results of users depend on these numbers: they must never change.
TEST(RangeErrorKernels, DrawTheNumbersThatTheyAlwaysDrew)
{
  const std::vector<double> deviates =
    Draw(lms3dGetPacketKernels(), { 1, 0, lms3dEffect::RANGE_NOISE, 7 });
  const double expected[] = { -0x1.1af8f0c6dfe41p+0, -0x1.09dd14165540ap+0, 0x1.fb25f1a502e11p-11,
    0x1.a4fe8ee41f4d4p-4 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(deviates[i], expected[i]);
  }
}

TEST(RangeErrorKernels, ReportTheSameBitsWithAllInstructionSets)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> ranges = { 1.0, nan, 1e-9, 0.004, 0.005, 0.006, 0.015, 3.14159, 80.0,
    1e7, 1e16, 1e300, std::numeric_limits<double>::max(), 0.0249999 };
  const std::vector<double> deviates = { 0.1, 1.0, -2.0, 0.0, 0.0, 0.0, -3.0, 0.5, 4.0, -8.0, 1.0,
    1.0, 1.0, 0.0 };
  const int count = static_cast<int>(ranges.size());
  const lms3dRangeErrorModel models[] = { { 0.0, 0.0, false, 0.0, 1.0 },
    { 0.01, 0.005, false, 0.0, 1.0 }, { -0.02, 0.005, true, 1.0, 100.0 },
    { 0.0, 0.0, true, 0.0094, 1.0 } };
  for (const lms3dRangeErrorModel& model : models)
  {
    std::vector<double> expected(ranges);
    lms3dGetPacketKernels(0).ReportRanges(model, deviates.data(), count, expected.data());
    EXPECT_TRUE(std::isnan(expected[1]));
    for (int i = 1; i < lms3dGetNumberOfPacketKernels(); ++i)
    {
      std::vector<double> found(ranges);
      lms3dGetPacketKernels(i).ReportRanges(model, deviates.data(), count, found.data());
      EXPECT_EQ(std::memcmp(found.data(), expected.data(), sizeof(double) * ranges.size()), 0);
    }
  }
}
