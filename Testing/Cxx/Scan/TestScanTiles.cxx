// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan that decides whole tiles has the bits of one that casts packet by packet.
 */
#include "Fixtures/CasterFixtures.h"
#include "Scan/TileScans.h"

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
  EXPECT_GT(ExpectEqualScans(mesh, sensors, { Far, 2.0, 3.0 }), 50);
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
  EXPECT_GT(ExpectEqualScans(mesh, { { 0.0, 0.0, 0.0 }, triangles[7][0] },
              { lms3dBeamPacket::NoRange, 1.5, 1e-40 }),
    10);
}

TEST(ScanTiles, OfABallHaveTheBitsOfPackets)
{
  const lms3dTriangleMesh mesh = MakeIcosphere(3);
  EXPECT_GT(ExpectEqualScans(
              mesh, { { 0.0, 0.0, 0.0 }, { 0.4, -0.3, 0.2 }, mesh.Points[20] }, { Far, 1.0 }),
    10);
}
