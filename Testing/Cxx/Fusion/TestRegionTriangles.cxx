// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which returns the triangles of a region leave outside.
 */
#include "Fusion/BorderFixtures.h"
#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Outlines/lms3dRegionCover.h"
#include "Fusion/Outlines/lms3dRegionTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
constexpr double Tolerance = 18.0;
constexpr double Reach = 1.2;
constexpr std::int32_t Width = 256;

/// Surface with returns below an uneven border. Beams passed a few cells above it.
lms3dRegion MakeRegion(std::uint32_t seed)
{
  std::mt19937 random(seed);
  lms3dRegion region;
  for (std::int32_t u = 0; u < Width; ++u)
  {
    const std::int32_t base = 60 + u / 8;
    const auto border = base + static_cast<std::int32_t>(random() % 3);
    for (std::int32_t v = 0; v < 128; ++v)
    {
      region.Make(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v));
      if (v <= border)
      {
        Set(&lms3dRegionBlock::May, u, v, region);
      }
    }
    Set(&lms3dRegionBlock::Must, u, border, region);
    Set(&lms3dRegionBlock::Passed, u, base + 5, region);
  }
  return region;
}
/// Whether the point is in a triangle.
bool IsCovered(const lms3dPoint2& point, const std::vector<lms3dTriangle2>& triangles)
{
  return std::any_of(triangles.begin(), triangles.end(),
    [&](const lms3dTriangle2& triangle) { return lms3dIsInTriangle(point, triangle, 1); });
}
} // namespace

/// A border may cut returns off, but moves back as far as the beams let it.
TEST(LMS3DRegionTriangles, LeaveFewReturnsOutside)
{
  int returns = 0;
  int outside = 0;
  std::size_t triangles = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    lms3dRegion region = MakeRegion(seed);
    const std::vector<lms3dTriangle2> made = lms3dTriangulateRegion(
      lms3dTraceOutlines(region), region, {}, lms3dFusedTile(0, 0), Tolerance, Reach);
    triangles += made.size();
    lms3dCoverRegion(made, region);
    for (std::int32_t v = 0; v < 128; ++v)
    {
      for (std::int32_t u = 0; u < Width; ++u)
      {
        const bool isReturn = region.Has(&lms3dRegionBlock::Must, u, v);
        returns += isReturn ? 1 : 0;
        outside += isReturn && !region.Has(&lms3dRegionBlock::Covered, u, v) ? 1 : 0;
        EXPECT_FALSE(region.Has(&lms3dRegionBlock::Passed, u, v) &&
          region.Has(&lms3dRegionBlock::Touched, u, v));
      }
    }
  }
  EXPECT_LT(40 * outside, returns);
  EXPECT_LT(triangles, 160U);
}

/// A return may lie anywhere in its cell. A triangle with all centres would miss the last cells.
TEST(LMS3DRegionTriangles, CoverWholeCellsOfANarrowStrip)
{
  lms3dRegion region;
  for (std::int32_t number = 0; number < 4; ++number)
  {
    region.Make(number, 0);
  }
  region.SetRow(&lms3dRegionBlock::May, 30, 20, 220, true, true, [](int) {});
  for (std::int32_t u = 20; u <= 220; u += 10)
  {
    Set(&lms3dRegionBlock::Must, u, 30, region);
  }
  const std::vector<lms3dTriangle2> made = lms3dTriangulateRegion(
    lms3dTraceOutlines(region), region, {}, lms3dFusedTile(0, 0), Tolerance, Reach);
  EXPECT_LE(made.size(), 2U);
  for (std::int32_t cell = 20; cell <= 220; cell += 10)
  {
    const double u = cell;
    for (const lms3dPoint2& point : { lms3dPoint2{ u, 30.0 }, lms3dPoint2{ u + 1.0, 30.0 },
           lms3dPoint2{ u, 31.0 }, lms3dPoint2{ u + 1.0, 31.0 } })
    {
      EXPECT_TRUE(IsCovered(point, made)) << point[0] << " " << point[1];
    }
  }
}
