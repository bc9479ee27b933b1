// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles that are needles, doubled, without area or in T-junctions, below VTK.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>

TEST(RobustInput, NeverHitsTrianglesWithoutArea)
{
  // Points, and lines that the beams meet, before a ball that they must see undisturbed.
  const lms3dTriangleMesh ball = MakeIcosphere(3);
  lms3dTriangleMesh mesh = ball;
  for (int i = 0; i < 300; ++i)
  {
    const Vector p = 0.5 * ball.Points[i];
    const Vector q = 0.5 * ball.Points[i + 1];
    Append(MakeMesh({ { { p, p, p } }, { { p, q, p } }, { { p, q, q } } }), mesh);
    Append(MakeMesh({ { { p, 2.0 * p, 1.5 * p } } }), mesh); // Collinear with the sensor as well.
  }
  const Target target(mesh);
  ExpectExactAndWhole(JudgeTriangles(target, { 0.0, 0.0, 0.0 }, 200));
  ExpectExactAndWhole(JudgeTriangles(target, { 0.1, 0.2, -0.3 }, 200));
}

TEST(RobustInput, SeesASceneOfNothingButATriangleWithoutArea)
{
  const Target target(MakeMesh({ { { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 2, 0 } } } }));
  const Tally sum = JudgeTriangles(target, { 0.0, 0.0, 0.0 }, 10);
  EXPECT_EQ(sum.Hits, 0);
  ExpectExact(sum);
}

TEST(RobustInput, ClosesASurfaceOfNeedles)
{
  for (double aspect : { 1e3, 1e5, 1e7, 1e9 })
  {
    const lms3dTriangleMesh mesh = MakeNeedleWall(aspect);
    for (bool isTurned : { false, true })
    {
      const Target target(isTurned ? Map(mesh, Turn) : mesh);
      const Vector sensor = isTurned ? Turn({ 0.0, 0.0, 0.25 }) : Vector{ 0.0, 0.0, 0.25 };
      ExpectExact(JudgeTriangles(target, sensor, 500));
    }
  }
}

TEST(RobustInput, SeesDuplicatedFacesAsOne)
{
  // Each face three times, once reversed and once from another corner.
  const lms3dTriangleMesh ball = MakeIcosphere(2);
  const std::int32_t faces = static_cast<std::int32_t>(ball.GetNumberOfTriangles());
  lms3dTriangleMesh reversed = ball;
  lms3dTriangleMesh turned = ball;
  for (std::int32_t i = 0; i < faces; ++i)
  {
    const auto& [a, b, c] = ball.Triangles[i];
    reversed.Triangles[i] = { a, c, b };
    turned.Triangles[i] = { b, c, a };
  }
  lms3dTriangleMesh mesh = ball;
  Append(reversed, mesh);
  Append(turned, mesh);
  const Target once(mesh);
  const Target again(mesh);
  const Vector sensor = { 0.1, 0.2, -0.3 };
  for (std::int32_t face = 0; face < faces; ++face)
  {
    Random random(face);
    Beams beams = once.MakeBeamsAt(face, sensor, random);
    beams[0] = beams[15]; // Faces share their corners and edges.
    const lms3dBeamPacket packet = once.Cast(sensor, beams);
    const lms3dBeamPacket other = again.Cast(sensor, beams);
    ASSERT_EQ(packet.Triangle[0] % faces, face);
    ASSERT_TRUE(std::equal(std::begin(packet.Range), std::end(packet.Range), other.Range));
    ASSERT_TRUE(std::equal(std::begin(packet.Triangle), std::end(packet.Triangle), other.Triangle));
  }
  ExpectExactAndWhole(JudgeTriangles(once, sensor, 500));
}

TEST(RobustInput, LeavesNothingButTrueGapsAtTJunctions)
{
  // What the beams see in the gap is what is there.
  const lms3dTriangleMesh mesh = MakeTJunction();
  const Vector& a = mesh.Points[0];
  const Vector& b = mesh.Points[1];
  const Vector& left = mesh.Points[2];
  const Vector& right = mesh.Points[5];
  const Target target(mesh);
  const Vector sensor = { 0.1, 0.2, 0.3 };
  const Tally sum = JudgeTriangles(target, sensor, 2000);
  ExpectExact(sum);
  // All aim at the surface, and only those at its sides and in the gap may pass.
  EXPECT_GT(sum.Hits, sum.Beams * 2 / 3);

  // A beam that passes the side by 1e-12 hits whichever triangle it passes into.
  Random random(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vector onSide = a + random.Get(0.1, 0.9) * (b - a);
    for (const Vector& inside : { left, right })
    {
      const Vector aim = onSide + 1e-12 * (inside - onSide);
      const lms3dBeamPacket packet = target.Cast(sensor, MakeSame(Normalize(aim - sensor)));
      ASSERT_NE(packet.Triangle[0], lms3dBeamPacket::NoTriangle);
      ASSERT_EQ(packet.Triangle[0] == 0, inside == left);
    }
  }
}
