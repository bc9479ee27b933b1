// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which triangle of a map has the corner nearest to a return.
 */
#include "Fusion/Scans/lms3dNearestCorner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace
{
// 40 x 40 corners, 1 m apart, on a wavy surface.
lms3dTriangleMesh MakeGrid()
{
  constexpr std::uint32_t Width = 40;
  lms3dTriangleMesh mesh;
  for (std::uint32_t row = 0; row < Width; ++row)
  {
    for (std::uint32_t column = 0; column < Width; ++column)
    {
      mesh.Points.push_back(
        { static_cast<double>(column), static_cast<double>(row), std::sin(0.7 * row * column) });
      if (row > 0 && column > 0)
      {
        const std::uint32_t corner = row * Width + column;
        mesh.Triangles.push_back({ corner - Width - 1, corner - Width, corner });
        mesh.Triangles.push_back({ corner - Width - 1, corner, corner - 1 });
      }
    }
  }
  return mesh;
}

// By looking at all corners.
std::int32_t FindSlowly(const lms3dTriangleMesh& mesh, const lms3dVector& point, double distance)
{
  std::pair<double, std::int32_t> nearest = { distance, -1 };
  for (std::size_t i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    for (int number = 0; number < 3; ++number)
    {
      const double* const corner = mesh.GetCorner(i, number);
      const double found =
        lms3dGetLength(lms3dSubtract({ corner[0], corner[1], corner[2] }, point));
      if (found < nearest.first || (found == nearest.first && nearest.second < 0))
      {
        nearest = { found, static_cast<std::int32_t>(i) };
      }
    }
  }
  return nearest.second;
}
} // namespace

TEST(NearestCorner, IsThatOfASearchOverAllCorners)
{
  const lms3dTriangleMesh mesh = MakeGrid();
  const lms3dNearestCorner corners(mesh);
  int found = 0;
  for (int i = 0; i < 500; ++i)
  {
    const lms3dVector point = { 0.083 * i, 40.0 * std::abs(std::sin(i)), std::cos(3.0 * i) };
    const std::int32_t triangle = corners.FindTriangle(point, 0.5);
    EXPECT_EQ(triangle, FindSlowly(mesh, point, 0.5)) << i;
    found += triangle >= 0 ? 1 : 0;
  }
  EXPECT_GT(found, 50);
  EXPECT_LT(found, 450);
}

TEST(NearestCorner, IsTheFirstOfSeveralTriangles)
{
  const lms3dTriangleMesh mesh = MakeGrid();
  const lms3dNearestCorner corners(mesh);
  EXPECT_EQ(corners.FindTriangle({ 0.0, 0.0, 0.0 }, 0.0), 0);
  EXPECT_EQ(corners.FindTriangle({ 1.0, 0.0, 0.0 }, 0.0), 0);
  EXPECT_EQ(corners.FindTriangle({ 2.0, 0.0, 0.0 }, 0.0), 2);
}

TEST(NearestCorner, IsNoneBeyondTheDistance)
{
  const lms3dTriangleMesh mesh = MakeGrid();
  EXPECT_EQ(lms3dNearestCorner(mesh).FindTriangle({ -0.5, 0.0, 0.0 }, 0.5), 0);
  EXPECT_EQ(lms3dNearestCorner(mesh).FindTriangle({ -0.5, 0.0, 0.0 }, 0.49), -1);
  EXPECT_EQ(lms3dNearestCorner(lms3dTriangleMesh()).FindTriangle({ 0.0, 0.0, 0.0 }, 1.0), -1);
}
