// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks when more than two corners of an outline become one.
 */
#include "Fusion/BorderFixtures.h"
#include "Fusion/lms3dCornerMerger.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
constexpr double Tolerance = 18.0;
constexpr double Reach = 1.2;
/// The tile with the cells from -1024 to 1023.
const lms3dFusedTile Tile(0, 0);
} // namespace

/// A border from right to left, between a return that it must not cut off and a beam that passed.
/// Neither of its two free corners can go alone, and no single corner can take the place of both.
TEST(LMS3DCornerChains, BecomeOneCornerAtOnce)
{
  lms3dRegion region;
  region.Make(0, 0);
  Set(&lms3dRegionBlock::Must, 22, 39, region);
  Set(&lms3dRegionBlock::Far, 22, 39, region);
  Set(&lms3dRegionBlock::Passed, 42, 40, region);
  const lms3dLoop border = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 39.9 }, { 42.0, 37.9 },
    { 22.0, 41.9 }, { 2.0, 39.9 } };
  lms3dOutlineCorners corners({ border }, { true, true, true, false, false, true });
  lms3dBorderLimits limits(region, border.size(), Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop merged = corners.GetLoops().front();
  EXPECT_EQ(merged, (lms3dLoop{ { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 39.9 }, { 2.0, 39.9 } }));
  ExpectLimitsKept(merged, region, Reach);
}

/// The same with another return above the straight border.
TEST(LMS3DCornerChains, StayIfTheyHaveReturns)
{
  lms3dRegion region;
  region.Make(0, 0);
  Set(&lms3dRegionBlock::Must, 22, 40, region);
  Set(&lms3dRegionBlock::Far, 22, 40, region);
  Set(&lms3dRegionBlock::Passed, 42, 40, region);
  const lms3dLoop border = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 39.9 }, { 42.0, 37.9 },
    { 22.0, 41.9 }, { 2.0, 39.9 } };
  lms3dOutlineCorners corners({ border }, { true, true, true, false, false, true });
  lms3dBorderLimits limits(region, border.size(), Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop merged = corners.GetLoops().front();
  EXPECT_GT(merged.size(), 4U);
  ExpectLimitsKept(merged, region, Reach);
}
