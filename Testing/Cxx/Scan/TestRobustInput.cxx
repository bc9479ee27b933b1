// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes that are very large, very far or very small, and sensors that stand on them: what
 * the header of vtkLMS3DScanFilter says about the exact method, tested without VTK.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <cmath>

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
    const lms3dBeamPacket packet = target.Cast(sensor, target.MakeBeamsAt(7, sensor, random));
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
