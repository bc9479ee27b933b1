// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks when more than two corners of an outline become one.
 */
#include "Fusion/BorderFixtures.h"
#include "Fusion/Outlines/lms3dCornerMerger.h"
#include "Fusion/Outlines/lms3dCornerPlaces.h"
#include "Fusion/Outlines/lms3dOutlineSimplifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
constexpr double Tolerance = 18.0;
constexpr double Reach = 1.2;
/// The tile with the cells from -1024 to 1023.
const lms3dFusedTile Tile(0, 0);

/// Surface below a roof, with a return and a beam that passed in every twelfth column. Cells
/// between them have surface or not.
lms3dRegion MakeRoughRoof(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> offset(0, 2);
  lms3dRegion region;
  for (std::int32_t u = 8; u < 248; ++u)
  {
    for (std::int32_t v = 4; v < 80 - std::abs(u - 128) / 3; ++v)
    {
      Set(&lms3dRegionBlock::May, u, v, region);
    }
  }
  for (std::int32_t u = 12; u < 244; u += 12)
  {
    const std::int32_t height = 80 - std::abs(u - 128) / 3;
    const std::int32_t must = height - 2 - offset(random);
    const std::int32_t passed = height + 2 + offset(random);
    Set(&lms3dRegionBlock::Must, u, must, region);
    Set(&lms3dRegionBlock::Far, u, must, region);
    Set(&lms3dRegionBlock::Passed, u + 6, passed, region);
    for (std::int32_t v = must + 1; v < passed; ++v)
    {
      for (std::int32_t column = u - 1; column <= u + 1; ++column)
      {
        const bool value = offset(random) > 0;
        region.SetRow(&lms3dRegionBlock::May, v, column, column, value, true, [](int) {});
      }
    }
  }
  return region;
}

std::size_t CountCorners(const std::vector<lms3dLoop>& loops)
{
  std::size_t count = 0;
  for (const lms3dLoop& loop : loops)
  {
    count += loop.size();
  }
  return count;
}

/// Merges the corners of a border from right to left, between a return in a row of cells and a beam
/// that passed. Expects that the limits of the border are kept.
lms3dLoop MergeBetweenReturnAndBeam(int row)
{
  lms3dRegion region;
  region.Make(0, 0);
  Set(&lms3dRegionBlock::Must, 22, row, region);
  Set(&lms3dRegionBlock::Far, 22, row, region);
  Set(&lms3dRegionBlock::Passed, 42, 40, region);
  const lms3dLoop border = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 39.9 }, { 42.0, 37.9 },
    { 22.0, 41.9 }, { 2.0, 39.9 } };
  lms3dOutlineCorners corners({ border }, { true, true, true, false, false, true });
  lms3dBorderLimits limits(region, border.size(), Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop merged = corners.GetLoops().front();
  ExpectLimitsKept(merged, region, Reach);
  return merged;
}
} // namespace

/// Neither of the two free corners can go alone, and no single corner can take the place of both.
TEST(LMS3DCornerChains, BecomeOneCornerAtOnce)
{
  EXPECT_EQ(MergeBetweenReturnAndBeam(39),
    (lms3dLoop{ { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 39.9 }, { 2.0, 39.9 } }));
}

/// The return is above the straight border.
TEST(LMS3DCornerChains, StayIfTheyHaveReturns)
{
  EXPECT_GT(MergeBetweenReturnAndBeam(40).size(), 4U);
}

/// A roof between two walls, with the notch in its middle as the third corner. Lines through the
/// ends and the outer corners meet above the notch.
TEST(LMS3DCornerChains, HavePlacesWhereLinesMeet)
{
  const std::vector<lms3dPoint2> roof = { { 40.0, 0.0 }, { 30.0, 10.0 }, { 20.0, 5.0 },
    { 10.0, 10.0 }, { 0.0, 0.0 } };
  const std::vector<lms3dPoint2> places = lms3dFindMergedPlaces(roof);
  const auto has = [&](const lms3dPoint2& expected)
  {
    return std::any_of(places.begin(), places.end(),
      [&](const lms3dPoint2& place)
      { return std::hypot(place[0] - expected[0], place[1] - expected[1]) < 1e-9; });
  };
  EXPECT_TRUE(has({ 20.0, 20.0 }));
  EXPECT_TRUE(has(roof[2])) << "the lines through the notch meet there";
  EXPECT_TRUE(has({ 8.0, 8.0 })) << "one of the lines goes through the notch";
  EXPECT_TRUE(has({ 32.0, 8.0 }));
  for (std::size_t i = 1; i < 4; ++i)
  {
    EXPECT_TRUE(has(roof[i]));
  }
}

/// A rough border between returns and beams that passed, beside one another. Chains of three
/// corners at most leave more than nine tenths of the corners.
TEST(LMS3DCornerChains, OfUpToFiveBecomeOne)
{
  std::size_t before = 0;
  std::size_t after = 0;
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const lms3dRegion region = MakeRoughRoof(seed);
    const std::vector<lms3dLoop> traced = lms3dTraceOutlines(region);
    const std::size_t count = CountCorners(traced);
    lms3dOutlineCorners corners(traced, std::vector<bool>(count, false));
    lms3dBorderLimits limits(region, count, Reach);
    lms3dOutlineSimplifier(Tolerance, corners, limits).Simplify();
    before += CountCorners(corners.GetLoops());
    lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
    after += CountCorners(corners.GetLoops());
  }
  EXPECT_LT(10 * after, 9 * before);
}
