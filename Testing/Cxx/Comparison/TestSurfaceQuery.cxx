// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts beams with one start and with starts of their own at surfaces.
 */
#include "Comparison/lms3dSurfaceQuery.h"
#include "Fixtures/MeshFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace
{
using Points = lms3dSurfaceQuery::Points;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Not a multiple of a packet.
constexpr std::size_t NumberOfPoints = 1003;

bool GoOn(double)
{
  return true;
}

Points MakePoints(double side, Random& random)
{
  Points points(NumberOfPoints);
  for (lms3dVector& point : points)
  {
    point = { random.Get(-side, side), random.Get(-side, side), random.Get(-side, side) };
  }
  return points;
}

// How far a beam from inside of the cube [-1, 1] gets.
double GetRangeInCube(const lms3dVector& origin, const lms3dVector& point)
{
  const lms3dVector beam = lms3dSubtract(point, origin);
  double range = Infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double wall = std::copysign(1.0, beam[axis]);
    range = std::min(range, (wall - origin[axis]) / beam[axis]);
  }
  return range * lms3dGetLength(beam);
}
} // namespace

TEST(SurfaceQuery, CopiesOfOneOriginGiveTheSameBits)
{
  Random random(1);
  const lms3dSurfaceQuery query(MakeIcosphere(3), GoOn);
  for (const lms3dVector& origin : { lms3dVector{ 3.0, -4.0, 5.0 }, lms3dVector{ 1e4, 0.0, 1e3 } })
  {
    const Points points = MakePoints(1.5, random);
    const std::vector<double> ranges = query.GetRangesTowards(origin, points, GoOn);
    EXPECT_EQ(ranges, query.GetRangesTowards(Points(points.size(), origin), points, GoOn));
    const auto misses = std::count(ranges.begin(), ranges.end(), Infinity);
    EXPECT_GT(misses, 100);
    EXPECT_LT(misses, 900);
  }
}

TEST(SurfaceQuery, EachBeamStartsAtItsOrigin)
{
  Random random(2);
  const lms3dSurfaceQuery query(MakeCube(7), GoOn);
  const Points origins = MakePoints(0.9, random);
  const Points points = MakePoints(2.0, random);
  const std::vector<double> ranges = query.GetRangesTowards(origins, points, GoOn);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double expected = GetRangeInCube(origins[i], points[i]);
    EXPECT_NEAR(ranges[i], expected, 1e-14 * expected) << i;
  }
}

TEST(SurfaceQuery, ABeamWithoutADirectionHasNoRange)
{
  Random random(3);
  const lms3dSurfaceQuery query(MakeCube(7), GoOn);
  Points origins = MakePoints(0.9, random);
  Points points = MakePoints(2.0, random);
  std::vector<double> expected = query.GetRangesTowards(origins, points, GoOn);
  points[5] = origins[5];
  points[20][1] = NotANumber;
  points.back()[2] = Infinity;
  origins[40][0] = NotANumber;
  origins[41][2] = -Infinity;
  for (std::size_t i : { std::size_t(5), std::size_t(20), std::size_t(40), std::size_t(41) })
  {
    expected[i] = Infinity;
  }
  expected.back() = Infinity;
  EXPECT_EQ(query.GetRangesTowards(origins, points, GoOn), expected);
}
