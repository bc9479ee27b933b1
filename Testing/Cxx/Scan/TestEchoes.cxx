// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rays of a beam become echoes, and the places of the rays.
 */
#include "Scan/lms3dEchoes.h"
#include "Scan/lms3dRayFan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
const double Pi = std::acos(-1.0);

void ExpectEcho(const std::vector<double>& ranges, double pulseLength, double range, int ray)
{
  const lms3dEcho echo = lms3dEchoes(pulseLength).FindReported(ranges);
  EXPECT_DOUBLE_EQ(echo.Range, range);
  EXPECT_EQ(echo.Ray, ray);
}

/// The share of the unit disc beyond a straight line at this distance from the centre.
double GetSegmentArea(double distance)
{
  const double d = std::clamp(distance, -1.0, 1.0);
  return (std::acos(d) - d * std::sqrt(1.0 - d * d)) / Pi;
}
} // namespace

TEST(Echoes, WithinAPulseAreMixed)
{
  ExpectEcho({ 5.0, 5.5, 6.0 }, 1.0, 5.5, 0);
  ExpectEcho({ 6.0, 5.0, 5.0, 5.0 }, 1.0, 5.25, 0);
}

TEST(Echoes, BeyondAPulseTheLargestWins)
{
  ExpectEcho({ 5.0, 7.0, 7.5 }, 1.0, 7.25, 1);
  ExpectEcho({ 7.0, 5.0, 5.2, 7.1, 5.1 }, 1.0, 5.1, 1);
}

TEST(Echoes, OfEqualOnesTheNearestWins)
{
  ExpectEcho({ 9.0, 5.0, 9.0, 5.0, 1.0 }, 1.0, 5.0, 1);
}

TEST(Echoes, FarRaysFormEchoesOfTheirOwn)
{
  // 5.0 to 6.0, then 6.1 to 7.0, although neighbours are near each other.
  ExpectEcho({ 5.0, 5.5, 6.0, 6.1, 6.3, 6.5, 7.0 }, 1.0, (6.1 + 6.3 + 6.5 + 7.0) / 4.0, 3);
}

TEST(Echoes, RaysWithoutAReturnAreNoPart)
{
  ExpectEcho({ NAN, 5.0, NAN, 5.5 }, 1.0, 5.25, 1);
  const lms3dEcho echo = lms3dEchoes(1.0).FindReported({ NAN, NAN });
  EXPECT_TRUE(std::isnan(echo.Range));
  EXPECT_EQ(echo.Ray, -1);
}

TEST(Echoes, EqualRangesStayAsTheyAre)
{
  for (double range : { 0.1, 1.0 / 3.0, 7.77, 1e-9, 1e9 })
  {
    for (double pulseLength : { 0.0, 1.0 })
    {
      EXPECT_EQ(lms3dEchoes(pulseLength).FindReported(std::vector<double>(37, range)).Range, range);
    }
  }
}

TEST(Echoes, WithoutPulseEachRangeIsItsOwn)
{
  ExpectEcho({ 5.0, 5.1, 5.1, 5.2 }, 0.0, 5.1, 1);
}

TEST(DiscPoints, StandForEqualParts)
{
  for (int count : { 1, 2, 7, 10, 19, 37, 1000 })
  {
    const std::vector<lms3dDiscPoint> points = lms3dGetDiscPoints(count);
    ASSERT_EQ(static_cast<int>(points.size()), count);
    EXPECT_EQ(points[0].U, 0.0);
    EXPECT_EQ(points[0].V, 0.0);
    double squares = 0.0;
    for (const lms3dDiscPoint& point : points)
    {
      EXPECT_LT(std::hypot(point.U, point.V), 1.0);
      squares += point.U * point.U + point.V * point.V;
    }
    // The mean square radius of a disc is 1/2. All of it but the centre's part is in the points.
    const double centre = 0.5 / count;
    EXPECT_NEAR(squares / count, 0.5 - centre / count, 1e-12) << count;
  }
}

TEST(DiscPoints, ShareOfAnEdgeFollowsTheArea)
{
  for (int count : { 7, 19, 37, 61, 169, 1027 })
  {
    const std::vector<lms3dDiscPoint> points = lms3dGetDiscPoints(count);
    for (int direction = 0; direction < 60; ++direction)
    {
      const double u = std::cos(Pi * direction / 60.0);
      const double v = std::sin(Pi * direction / 60.0);
      for (int step = -110; step < 110; ++step)
      {
        const double distance = 0.01 * step;
        const auto beyond = std::count_if(points.begin(), points.end(),
          [&](const lms3dDiscPoint& point) { return point.U * u + point.V * v > distance; });
        EXPECT_NEAR(
          static_cast<double>(beyond) / count, GetSegmentArea(distance), 0.55 / std::sqrt(count))
          << count << ' ' << direction << ' ' << distance;
      }
    }
  }
}
