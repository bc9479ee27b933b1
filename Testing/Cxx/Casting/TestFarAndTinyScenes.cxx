// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The exact caster where scenes are a speck: very far away, or very small.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/// A beam that hits nearer than `farthest`, also if other triangles are there.
Tally JudgeNearSide(const Target& ball, double farthest, const Vector& sensor,
  const Vector& direction, const lms3dBeamPacket& packet, int beam)
{
  const std::int32_t triangle = packet.Triangle[beam];
  if (triangle == lms3dBeamPacket::NoTriangle)
  {
    return { 1, 1, 1, 0, 0.0 };
  }
  const ExactReference::Hit own = ball.Reference.Cast(triangle, sensor, direction);
  const bool isTrue = own.Triangle == triangle && own.Range < farthest;
  return { 1, 1, 0, !isTrue, isTrue ? ExactReference::GetError(packet.Range[beam], own) : 0.0 };
}

/// Beams at the near side of a ball around the origin, that hit it well before its centre. Where
/// the sensor is so far away that the reference cannot separate distant triangles, this can.
Tally JudgeNearSide(const Target& ball, double radius, const Vector& sensor, Random& random)
{
  const double distance = GetLength(sensor);
  Beams beams;
  for (Vector& beam : beams)
  {
    beam = Normalize(random.Get(0.0, 0.5) * radius * random.GetDirection() - sensor);
  }
  const lms3dBeamPacket packet = ball.Cast(sensor, beams);
  Tally sum;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    sum += JudgeNearSide(ball, distance - 0.5 * radius, sensor, beams[i], packet, i);
  }
  return sum;
}
} // namespace

class EachDistance : public testing::TestWithParam<int>
{
};

TEST_P(EachDistance, SeesTheNearSideOfABallOfManyTriangles)
{
  const Target ball(MakeIcosphere(6));
  ASSERT_EQ(ball.GetMesh().GetNumberOfTriangles(), 81920u);
  const double distance = std::pow(10.0, GetParam());
  const Tally sum = JudgeEach(60,
    [&](std::size_t number)
    {
      Random random(number);
      const Vector axis = number % 4 ? random.GetDirection() : Vector{ 0.0, 1.0, 0.0 };
      return JudgeNearSide(ball, 1.0, distance * axis, random);
    });
  ExpectExactAndWhole(sum);
}

INSTANTIATE_TEST_SUITE_P(FarScenes, EachDistance, testing::Range(3, 16));

TEST(FarScenes, AreSeenAsTheyAre)
{
  const Target ball(MakeIcosphere(4));
  Random random(17);
  for (double distance : { 1e3, 1e5, 1e7, 1e9 })
  {
    const Tally sum = JudgeTriangles(ball, distance * random.GetDirection(), 100);
    EXPECT_GT(sum.Hits, sum.Beams / 2) << distance;
    ExpectExact(sum);
  }
}

TEST(TinyScenes, AreSeenFromWithin)
{
  for (double radius : { 1e-9, 1e-15, 1e-20, 1e-22, 1e-24, 1e-50 })
  {
    SCOPED_TRACE(radius);
    const Target ball(Move(MakeIcosphere(3), radius, {}));
    ExpectExactAndWhole(JudgeTriangles(ball, {}, 300));
    ExpectExactAndWhole(JudgeTriangles(ball, radius * Vector{ 0.1, 0.2, -0.3 }, 300));
  }
}
