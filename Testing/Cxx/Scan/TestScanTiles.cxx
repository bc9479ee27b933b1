// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan that decides whole tiles has the bits of one that casts packet by packet.
 */
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneFixtures.h"
#include "Scan/TileScans.h"

#include "Casting/lms3dExactView.h"
#include "Casting/lms3dTileSearch.h"
#include "Device/lms3dScanGeometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr double Far = 1e3;
} // namespace

// On faces, edges, corners and planes, inside and outside. The beams at right angles to a wall have
// the maximum range exactly.
TEST(ScanTiles, OfACubeAndBlocksHaveTheBitsOfPackets)
{
  lms3dTriangleMesh mesh = Move(MakeCube(3), 6.0, { 0.0, 0.0, 0.0 });
  Append(MakeBlocks(), mesh);
  const std::vector<Vector> sensors = { { 0.1, -0.2, 0.3 }, { 0.0, 0.0, 0.0 }, mesh.Points[0],
    mesh.Points[5], 0.5 * (mesh.Points[0] + mesh.Points[1]), { 1.0, 1.0, 1.0 },
    { 30.0, 0.0, 0.0 } };
  EXPECT_EQ(ExpectEqualScans(mesh, sensors, { Far, 2.0, 3.0 }), 432);
}

TEST(ScanTiles, OfARandomSoupHaveTheBitsOfPackets)
{
  Random random(19);
  std::vector<std::array<Vector, 3>> triangles;
  for (int i = 0; i < 300; ++i)
  {
    const Vector a = random.Get(0.5, 5.0) * random.GetDirection();
    const double size = std::pow(10.0, random.Get(-2.0, 1.0));
    triangles.push_back({ a, a + size * random.GetDirection(), a + size * random.GetDirection() });
    if (i % 10 == 0)
    {
      triangles.push_back(triangles.back()); // The first of two equal ones counts.
    }
    if (i % 30 == 0)
    {
      triangles.push_back({ a, a, triangles.back()[1] });
    }
  }
  const lms3dTriangleMesh mesh = MakeMesh(triangles);
  EXPECT_EQ(ExpectEqualScans(mesh, { { 0.0, 0.0, 0.0 }, triangles[7][0] },
              { lms3dBeamPacket::NoRange, 1.5, 1e-40 }),
    162);
}

TEST(ScanTiles, OfABallHaveTheBitsOfPackets)
{
  const lms3dTriangleMesh mesh = MakeIcosphere(3);
  EXPECT_EQ(ExpectEqualScans(
              mesh, { { 0.0, 0.0, 0.0 }, { 0.4, -0.3, 0.2 }, mesh.Points[20] }, { Far, 1.0 }),
    108);
}

// The inverse of the corner's distance overflows. Parts of the triangle are in front of the walls.
TEST(ScanTiles, WithACornerNextToTheSensorHaveTheBitsOfPackets)
{
  lms3dTriangleMesh mesh = Move(MakeCube(3), 6.0, { 0.0, 0.0, 0.0 });
  Append(MakeMesh({ { Vector{ 1e-310, 0.0, 5e-311 }, Vector{ -2.0, 2.0, 1.0 },
           Vector{ -2.0, -2.0, 1.0 } } }),
    mesh);
  EXPECT_TRUE(ExpectEqualScan(mesh, { 0.0, 0.0, 0.0 }, Far));
}

// The nearest of seven walls in each direction differs from the others by less than single
// precision resolves.
TEST(ScanTiles, OfWallsInNearlyOnePlaneHaveTheBitsOfPackets)
{
  lms3dTriangleMesh mesh;
  Random random(5);
  for (int i = 0; i < 7; ++i)
  {
    Append(Map(Move(MakeCube(1), 6.0, { 0.0, 0.0, 0.0 }),
             [&random](const Vector& p)
             {
               return Vector{ p[0] * (1.0 + 1e-7 * random.Get(-1.0, 1.0)),
                 p[1] * (1.0 + 1e-7 * random.Get(-1.0, 1.0)),
                 p[2] * (1.0 + 1e-7 * random.Get(-1.0, 1.0)) };
             }),
      mesh);
  }
  EXPECT_EQ(ExpectEqualScans(mesh, { { 0.1, -0.2, 0.3 } }, { Far }), 27);
}

// From the middle of a face and of an edge of the scene, too.
TEST(ScanTiles, OfTheRoomHaveTheBitsOfPackets)
{
  const lms3dTriangleMesh mesh = MakeMesh(ReadRoom());
  const auto& first = mesh.Triangles[0];
  const Vector& a = mesh.Points[first[0]];
  const Vector& b = mesh.Points[first[1]];
  const Vector& c = mesh.Points[first[2]];
  EXPECT_EQ(
    ExpectEqualScans(mesh, { { 0.3, -0.2, 1.0 }, 0.5 * (a + b), 1.0 / 3.0 * (a + b + c) }, { Far }),
    81);
}

TEST(ScanTiles, OfTheBuildingHaveTheBitsOfPackets)
{
  EXPECT_EQ(ExpectEqualScans(MakeMesh(ReadBuilding()), { { 0.3, -0.2, 1.0 } }, { Far }), 21);
}

// From the middle of its points.
TEST(ScanTiles, OfTheTeapotHaveTheBitsOfPackets)
{
  const lms3dTriangleMesh mesh = MakeMesh(ReadTeapot());
  Vector sum = { 0.0, 0.0, 0.0 };
  for (const Vector& point : mesh.Points)
  {
    sum = sum + point;
  }
  const Vector middle = 1.0 / static_cast<double>(mesh.Points.size()) * sum;
  EXPECT_EQ(ExpectEqualScans(mesh, { middle }, { Far }), 21);
}

// In so dense a cloud, blocks of tiles have too many candidates, and the division by triangles is
// given up.
TEST(ScanTiles, OfTooManyCandidatesHaveTheBitsOfPackets)
{
  Random random(36);
  std::vector<std::array<Vector, 3>> triangles;
  for (int i = 0; i < 1800; ++i)
  {
    const Vector a = random.Get(1.0, 9.0) * random.GetDirection();
    triangles.push_back({ a, a + random.GetDirection(), a + random.GetDirection() });
  }
  const lms3dTriangleMesh mesh = MakeMesh(triangles);
  const double alpha[2] = { -90.0, 90.0 };
  const double beta[2] = { 0.0, 360.0 };
  const lms3dScanGeometry geometry(alpha, 91, beta, 360);
  const Vector sensor = { 0.0, 0.0, 0.0 };
  const lms3dBeamDirections directions(
    geometry, lms3dPose::FromOrientation(sensor.data(), sensor.data()));
  const lms3dBeamGrid grid = { geometry.GetNumberOfTurns(), geometry.GetNumberOfBeams(),
    &directions.GetFanAxis(0), geometry.GetBetaStep(), geometry.GetAlphaCosines().data(),
    geometry.GetAlphaSines().data(), directions.GetUp() };
  lms3dExactView view(mesh, { { 0.0, 0.0, 0.0 }, Far }, 1.0);
  ASSERT_TRUE(lms3dTileSearch::IsSuitable(grid, triangles.size()));
  EXPECT_EQ(lms3dTileSearch::New(view, grid), nullptr);
  ExpectEqualScan(mesh, sensor, Far);
}
