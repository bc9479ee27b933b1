// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans of scenes too large for tiles of single triangles have the bits of packets, too:
 * tiles leave out clusters of triangles there.
 */
#include "Fixtures/CasterFixtures.h"
#include "Scan/TileScans.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
constexpr int Cells = 60;
constexpr double Far = 1e3;

double GetHeight(int i, int j)
{
  return 2.0 * std::sin(0.31 * i) * std::cos(0.23 * j) + 0.3 * std::sin(1.7 * i + 0.9 * j);
}

/// Hills of 60 m x 60 m under an open sky, 7,200 triangles.
lms3dTriangleMesh MakeHills()
{
  lms3dTriangleMesh mesh;
  for (int i = 0; i <= Cells; ++i)
  {
    for (int j = 0; j <= Cells; ++j)
    {
      mesh.Points.push_back({ i - 30.0, j - 30.0, GetHeight(i, j) });
    }
  }
  for (std::uint32_t i = 0; i < Cells; ++i)
  {
    for (std::uint32_t j = 0; j < Cells; ++j)
    {
      const std::uint32_t a = i * (Cells + 1) + j;
      const std::uint32_t b = a + Cells + 1;
      mesh.Triangles.push_back({ a, b, b + 1 });
      mesh.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

Vector GetPlaceOnHills(int i, int j, double height)
{
  return { i - 30.0, j - 30.0, GetHeight(i, j) + height };
}
} // namespace

TEST(ScanClusters, OfHillsHaveTheBitsOfPackets)
{
  EXPECT_GT(ExpectEqualScans(MakeHills(),
              { GetPlaceOnHills(30, 30, 2.0), GetPlaceOnHills(31, 29, 0.0),
                GetPlaceOnHills(3, 50, 0.01), { 0.25, -0.75, 12.0 }, { 29.9, 29.9, -1.0 } },
              { Far, 5.0 }),
    50);
}

// Large triangles are clusters of their own; a box around all of them has the sensor in it.
TEST(ScanClusters, WithLargeTrianglesHaveTheBitsOfPackets)
{
  lms3dTriangleMesh mesh = MakeHills();
  Append(MakeMesh({ { Vector{ -40.0, -40.0, -3.0 }, Vector{ 40.0, -40.0, -3.0 },
                      Vector{ 0.0, 50.0, -3.0 } },
           { Vector{ -30.0, -30.0, 9.0 }, Vector{ 30.0, -30.0, 9.0 }, Vector{ 0.0, 30.0, 1.0 } } }),
    mesh);
  EXPECT_GT(
    ExpectEqualScans(mesh, { GetPlaceOnHills(20, 33, 1.5), { 0.0, 0.0, 9.0 } }, { Far }), 20);
}

TEST(ScanClusters, OfACloudHaveTheBitsOfPackets)
{
  Random random(35);
  std::vector<std::array<Vector, 3>> triangles;
  for (int i = 0; i < 6000; ++i)
  {
    const Vector a = random.Get(0.5, 50.0) * random.GetDirection();
    const double size = std::pow(10.0, random.Get(-3.0, 1.0));
    triangles.push_back({ a, a + size * random.GetDirection(), a + size * random.GetDirection() });
  }
  EXPECT_GT(
    ExpectEqualScans(MakeMesh(triangles), { { 0.0, 0.0, 0.0 }, triangles[9][1] }, { Far }), 20);
}
