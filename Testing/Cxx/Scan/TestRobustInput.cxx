// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes that are badly made, very large, very far or very small, and sensors that stand on
 * them: what the header of vtkLMS3DScanFilter says about the exact method, tested without VTK.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// --- Bad triangles ------------------------------------------------------------------------------

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
    Beams beams = once.AimAt(face, sensor, random);
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

// --- Where the sensor stands --------------------------------------------------------------------

TEST(RobustInput, SeesFreeSpaceFromAFaceAnEdgeAndAVertex)
{
  // On a cube's top: beams upward hit nothing, and beams downward hit the cube's other sides.
  const Target cube(MakeCube(2));
  for (const Vector& sensor : { Vector{ 0.25, 0.5, 1.0 }, Vector{ 0.5, 0.5, 1.0 },
         Vector{ 0.0, 0.0, 1.0 }, Vector{ 1.0, 0.25, 1.0 }, Vector{ 1.0, 1.0, 1.0 } })
  {
    ExpectExact(JudgeAllAround(cube, sensor, 200));
    for (const Vector& free :
      { Vector{ 0, 0, 1 }, Vector{ 0.8, 0.0, 0.6 }, Vector{ -0.6, 0.0, 0.8 } })
    {
      EXPECT_EQ(cube.Cast(sensor, MakeSame(free)).Triangle[0], lms3dBeamPacket::NoTriangle);
    }
    if (sensor[0] < 1.0)
    {
      EXPECT_EQ(cube.Cast(sensor, MakeSame({ 0, 0, -1 })).Range[0], 2.0);
    }
  }
}

TEST(RobustInput, ReturnsNothingAtARangeOfZero)
{
  // A vertex of a ball, and points of its faces, which rounding puts on either side of them.
  const Target ball(MakeIcosphere(3));
  const lms3dTriangleMesh& mesh = ball.GetMesh();
  for (std::size_t triangle = 0; triangle < 200; ++triangle)
  {
    const Vector& a = mesh.Points[mesh.Triangles[triangle][0]];
    const Vector& b = mesh.Points[mesh.Triangles[triangle][1]];
    const Vector& c = mesh.Points[mesh.Triangles[triangle][2]];
    for (const Vector& sensor : { a, 0.5 * (a + b), 0.4 * a + 0.3 * b + 0.3 * c })
    {
      ExpectExact(JudgeAllAround(ball, sensor, 4));
    }
    const lms3dBeamPacket packet = ball.Cast(a, MakeSame(-1.0 * a));
    ASSERT_GT(packet.Range[0], 1.9) << "through the ball from its vertex";
  }
}

TEST(RobustInput, SeesASceneFromFarAway)
{
  for (double diagonals : { 1e3, 1e4, 1e5, 1e6, 1e7 })
  {
    const Target target(MakeIcosphere(3));
    Random random(5);
    const Vector sensor = 2.0 * std::sqrt(3.0) * diagonals * random.GetDirection();
    const Tally sum = JudgeTriangles(target, sensor, 300);
    EXPECT_GT(sum.Hits, sum.Beams * 3 / 4) << diagonals;
    ExpectExact(sum);
  }
}

// --- Sizes and offsets --------------------------------------------------------------------------

TEST(RobustInput, SeesScenesOfAnySizeAtAnyOffset)
{
  for (double size : { 1e-6, 1e-3, 1.0, 1e3, 1e5, 1e7 })
  {
    for (double offset : { 0.0, 1e5, 1e7 })
    {
      // A ball of 1e-6 m at an offset of 1e7 m has no shape left: rounding is 2e-9 m.
      const Vector center = { offset, 0.3 * offset, -0.7 * offset };
      const Target target(Move(MakeIcosphere(2), size, center));
      const Vector sensor = size * Vector{ 0.1, 0.2, -0.3 } + center;
      const Tally sum = JudgeTriangles(target, sensor, 200);
      EXPECT_EQ(sum.Hits, sum.Beams) << size << " m at " << offset << " m";
      ExpectExact(sum);
    }
  }
}

TEST(RobustInput, SeesATerrainWithAVeryLargeSkirt)
{
  // Embree's single precision is that of the whole scene.
  lms3dTriangleMesh mesh = Move(MakeCube(20), 1.0, { 0.0, 0.0, -2.0 });
  Append(Move(MakeCube(1), 1e6, { 0.0, 0.0, 0.0 }), mesh);
  const Target target(mesh);
  ExpectExactAndWhole(JudgeTriangles(target, { 0.1, 0.2, 0.3 }, 1000));
}

TEST(RobustInput, SeesATerrainOnAGroundWithoutEnd)
{
  // Small triangles, and one whose box holds them all.
  constexpr double Half = 1e7;
  lms3dTriangleMesh mesh =
    MakeMesh({ { { { -Half, -Half, 0 }, { Half, -Half, 0 }, { 0, Half, 0 } } } });
  Random random(31);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector p = { random.Get(-50, 50), random.Get(-50, 50), random.Get(0, 2) };
    const Vector u = 0.3 * random.GetDirection();
    const Vector v = 0.3 * random.GetDirection();
    Append(MakeMesh({ { { p, p + u, p + v } } }), mesh);
  }
  const Target target(mesh);
  ExpectExact(JudgeTriangles(target, { 0.1, 0.2, 3.0 }, 500));
  ExpectExact(JudgeAllAround(target, { 0.1, 0.2, 3.0 }, 500));
  ExpectExact(JudgeAllAround(target, { 0.1, 0.2, 1e-3 }, 100));
  EXPECT_EQ(target.Cast({ 1e6, 0, 3.0 }, MakeSame({ 0, 0, -1 })).Range[0], 3.0);
}

// --- Many surfaces, one behind the other --------------------------------------------------------

TEST(RobustInput, TellsNearShellsApart)
{
  for (double gap : { 1e-5, 1e-7, 1e-9, 1e-11 })
  {
    const lms3dTriangleMesh ball = MakeIcosphere(3);
    lms3dTriangleMesh mesh = Move(ball, 1.0 + gap, {});
    Append(ball, mesh);
    const Target target(mesh);
    const Vector sensor = { 0.1, 0.2, -0.3 };
    ExpectExactAndWhole(JudgeTriangles(target, sensor, 500));

    // The inner shell, whose triangles have the larger numbers.
    Random random(1);
    const lms3dBeamPacket packet = target.Cast(sensor, target.AimAt(7, sensor, random));
    for (std::int32_t triangle : packet.Triangle)
    {
      EXPECT_GE(triangle, static_cast<std::int32_t>(ball.GetNumberOfTriangles())) << gap;
    }
  }
}

TEST(RobustInput, SeesTheInnermostOfManyBoxes)
{
  lms3dTriangleMesh mesh;
  for (int i = 100; i > 0; --i)
  {
    Append(Move(MakeCube(1), 1.0 + 0.01 * i, {}), mesh);
  }
  const Target target(mesh);
  const Vector sensor = { 0.1, 0.2, -0.3 };
  ExpectExactAndWhole(JudgeTriangles(target, sensor, 60));
  ExpectExactAndWhole(JudgeTriangles(target, { 0.0, 0.0, 0.0 }, 60));
  EXPECT_EQ(target.Cast({ 0, 0, 0 }, MakeSame({ 1, 0, 0 })).Range[0], 1.01);
}
