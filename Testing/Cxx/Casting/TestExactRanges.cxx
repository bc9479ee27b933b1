// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges of the exact caster: right to the last bits for any shape of triangle and
 * however the sensor stands to it, and held to the limit to the bit.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

// --- Badly shaped triangles ---------------------------------------------------------------------

namespace
{
/// Triangles a metre long anywhere within 10 m, `aspect` times longer than wide.
lms3dTriangleMesh MakeNeedles(double aspect)
{
  std::vector<std::array<Vector, 3>> needles;
  Random random(7);
  for (int i = 0; i < 500; ++i)
  {
    const Vector a = { random.Get(-10, 10), random.Get(-10, 10), random.Get(-10, 10) };
    const Vector along = random.GetDirection();
    const Vector across = random.GetDirection();
    needles.push_back({ a, a + along, a + random.Get() * along + (1.0 / aspect) * across });
  }
  return MakeMesh(needles);
}

/// Needles along the axes, where coordinates are fine enough for any width.
lms3dTriangleMesh MakeNeedlesOnAxes(double aspect)
{
  std::vector<std::array<Vector, 3>> needles;
  Random random(8);
  for (int i = 0; i < 60; ++i)
  {
    const int axis = i % 3;
    std::array<Vector, 3> needle = {};
    needle[0][axis] = i - 30.0;
    needle[1][axis] = i - 29.0;
    needle[2][axis] = i - random.Get(29.0, 30.0);
    needle[2][(axis + 1) % 3] = random.Get(0.5, 1.0) / aspect;
    needle[2][(axis + 2) % 3] = random.Get(-1.0, 1.0) / aspect;
    needles.push_back(needle);
  }
  return MakeMesh(needles);
}
} // namespace

TEST(ExactRanges, AreRightOnNeedles)
{
  for (double aspect : { 1e1, 1e3, 1e5, 1e7, 1e9, 1e11, 1e13, 1e15, 1e17 })
  {
    SCOPED_TRACE(aspect);
    const Vector sensor = { 0.1, 0.2, 0.3 };
    ExpectExact(JudgeTriangles(Target(MakeNeedles(aspect)), sensor, 400));
    const Tally sum = JudgeTriangles(Target(MakeNeedlesOnAxes(aspect)), sensor, 200);
    EXPECT_GT(sum.Hits, 0);
    ExpectExact(sum);
  }
}

// --- A sensor close to the plane of a triangle --------------------------------------------------

namespace
{
using Place = Vector (*)(const Vector&);

Vector Stay(const Vector& p)
{
  return p;
}

/// A right-angled triangle over x and y with one corner at the origin, where coordinates are
/// fine enough for any height. It is the triangle's first, second or third.
struct Corner
{
  Corner(double size, int shape, int number)
  {
    const Vector corners[3] = { {}, { size, 0, 0 }, { 0, size, 0 } };
    const Vector p = corners[(shape + 1) % 3] - corners[shape];
    const Vector q = corners[(shape + 2) % 3] - corners[shape];
    this->Triangle[number] = {};
    this->Triangle[(number + 1) % 3] = p;
    this->Triangle[(number + 2) % 3] = q;
    this->Inwards = Normalize(Normalize(p) + Normalize(q));
  }

  std::array<Vector, 3> Triangle;
  /// Along the triangle, away from its edges.
  Vector Inwards;
};

/// Points of the triangle, as many close to the sensor as far away.
Tally JudgeGrazing(const Target& target, const Vector& sensor, const Vector& foot)
{
  return JudgeEach(6,
    [&](std::size_t number)
    {
      Random random(number);
      Beams beams = target.GetRelativePoints(0, sensor, random);
      for (Vector& beam : beams)
      {
        const Vector toFoot = foot - sensor;
        beam = Normalize(toFoot + std::pow(10.0, random.Get(-16.0, 0.0)) * (beam - toFoot));
      }
      return Judge(target, sensor, beams);
    });
}

/// The sensor stands above a point inside, so far from the corner at the origin.
Tally JudgeNearCorner(const Corner& corner, Place place, double distance, double height)
{
  std::array<Vector, 3> triangle;
  std::transform(corner.Triangle.begin(), corner.Triangle.end(), triangle.begin(), place);
  const Target target(MakeMesh({ triangle }));
  const Vector foot = distance * corner.Inwards;
  const Vector sensor = place(foot + Vector{ 0, 0, height });
  Tally sum = JudgeTriangles(target, sensor, 6);
  sum += JudgeGrazing(target, sensor, place(foot));
  return sum;
}
} // namespace

class EachSize : public testing::TestWithParam<double>
{
};

TEST_P(EachSize, AreRightAtGrazingAngles)
{
  const double size = GetParam();
  Tally sum;
  for (double height : { 1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13 })
  {
    for (int i = 0; i < 9; ++i)
    {
      for (double distance : { 1.5e-3, 0.25, 0.25 * size })
      {
        sum += JudgeNearCorner(Corner(size, i / 3, i % 3), Stay, distance, height);
        sum += JudgeNearCorner(Corner(size, i / 3, i % 3), Turn, distance, height);
      }
    }
  }
  EXPECT_GT(sum.Hits, sum.Beams / 2);
  ExpectExact(sum);
}

INSTANTIATE_TEST_SUITE_P(ExactRanges, EachSize, testing::Values(1.0, 1e2, 1e4, 1e5, 1e6));

// --- The limit ----------------------------------------------------------------------------------

TEST(ExactRanges, CountUpToTheLimitAndNotAUnitFarther)
{
  const Target target(MakeIcosphere(3));
  const Vector sensor = { 0.1, 0.2, -0.3 };
  Random random(2);
  for (std::size_t triangle = 0; triangle < target.GetMesh().GetNumberOfTriangles(); ++triangle)
  {
    const Beams beams = target.MakeBeamsAt(triangle, sensor, random);
    const lms3dBeamPacket free = target.Cast(sensor, beams);
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      const double range = free.Range[i];
      const lms3dBeamPacket within = target.Cast(sensor, MakeSame(beams[i]), range);
      ASSERT_EQ(within.Range[0], range);
      ASSERT_EQ(within.Triangle[0], free.Triangle[i]);
      const lms3dBeamPacket beyond =
        target.Cast(sensor, MakeSame(beams[i]), std::nextafter(range, 0.0));
      ASSERT_EQ(beyond.Range[0], lms3dBeamPacket::NoRange);
      ASSERT_EQ(beyond.Triangle[0], lms3dBeamPacket::NoTriangle);
    }
  }
}

TEST(ExactRanges, CountWhereTwoSurfacesTieAtTheLimit)
{
  // Two triangles that a beam meets within some units in the last place of one another.
  Random random(9);
  for (int i = 0; i < 3000; ++i)
  {
    const Vector direction = random.GetDirection();
    const auto makeTriangle = [&](double distance)
    {
      const Vector p = distance * direction;
      const Vector u = random.GetDirection();
      const Vector v = random.GetDirection();
      return std::array<Vector, 3>{ p + u, p + v, p - (u + v) };
    };
    const std::array<Vector, 3> a = makeTriangle(2.0);
    const std::array<Vector, 3> b = makeTriangle(2.0 + std::pow(10.0, random.Get(-16.0, -11.0)));
    const Vector sensor = {};
    const auto cast = [&](const std::vector<std::array<Vector, 3>>& triangles, double limit)
    { return Target(MakeMesh(triangles)).Cast(sensor, MakeSame(direction), limit).Range[0]; };
    const double farthest = 3.0;
    const double ranges[2] = { cast({ a }, farthest), cast({ b }, farthest) };
    const double nearest = std::min(ranges[0], ranges[1]);
    ASSERT_LT(nearest, farthest);
    for (double range : ranges)
    {
      for (double limit : { range, std::nextafter(range, 0.0), std::nextafter(range, farthest) })
      {
        const double both = cast({ a, b }, limit);
        if (limit < nearest)
        {
          ASSERT_EQ(both, lms3dBeamPacket::NoRange) << i;
        }
        else
        {
          ASSERT_TRUE(both == ranges[0] || both == ranges[1]) << i << ": " << both;
          ASSERT_LE(both, limit) << i;
        }
      }
    }
  }
}
