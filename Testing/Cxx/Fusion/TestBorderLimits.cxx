// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which cells a border may gain, and which returns it may cut off.
 */
#include "Fusion/Outlines/lms3dBorderLimits.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace
{
using Triangle = lms3dBorderLimits::Triangle;

constexpr double Reach = 1.2;
// The region lies above row 10. Below it, the border makes a bend that may go.
constexpr Triangle Lost = { { { 10.0, 10.0 }, { 20.0, 8.0 }, { 30.0, 10.0 } } };
// The same with a notch.
constexpr Triangle Gained = { { { 10.0, 10.0 }, { 20.0, 12.0 }, { 30.0, 10.0 } } };

void Set(lms3dRegion::BitsOf bits, std::int32_t u, std::int32_t v, lms3dRegion& region)
{
  region.SetRow(bits, v, u, u, true, true, [](int) {});
}

lms3dRegion MakeRegion()
{
  lms3dRegion region;
  region.Make(0, 0);
  return region;
}

bool MayJoin(const Triangle& triangle, const lms3dRegion& region)
{
  return lms3dBorderLimits(region, 2, Reach).MayJoin(triangle, 0, 1);
}
} // namespace

TEST(LMS3DBorderLimits, CutOffReturnsBesideBeamsOnly)
{
  lms3dRegion region = MakeRegion();
  EXPECT_TRUE(MayJoin(Lost, region));
  Set(&lms3dRegionBlock::Must, 20, 9, region);
  EXPECT_FALSE(MayJoin(Lost, region));
  Set(&lms3dRegionBlock::Passed, 20, 6, region);
  EXPECT_TRUE(MayJoin(Lost, region));
  Set(&lms3dRegionBlock::Far, 20, 9, region);
  EXPECT_FALSE(MayJoin(Lost, region));
}

TEST(LMS3DBorderLimits, CutOffNearReturnsOnly)
{
  lms3dRegion region = MakeRegion();
  Set(&lms3dRegionBlock::Must, 20, 8, region);
  Set(&lms3dRegionBlock::Passed, 20, 6, region);
  EXPECT_FALSE(MayJoin(Lost, region));
}

TEST(LMS3DBorderLimits, GainNoBeamsThatPassed)
{
  lms3dRegion region = MakeRegion();
  EXPECT_TRUE(MayJoin(Gained, region));
  Set(&lms3dRegionBlock::Passed, 20, 10, region);
  EXPECT_FALSE(MayJoin(Gained, region));
}

TEST(LMS3DBorderLimits, GainCellsInBlocksOnly)
{
  EXPECT_FALSE(MayJoin(Gained, lms3dRegion()));
}

/// An edge that has cut off a return does not move away from it.
TEST(LMS3DBorderLimits, RememberWhatWasCutOff)
{
  lms3dRegion region = MakeRegion();
  Set(&lms3dRegionBlock::Must, 20, 9, region);
  Set(&lms3dRegionBlock::Passed, 20, 6, region);
  const Triangle second = { { { 10.0, 10.0 }, { 30.0, 10.0 }, { 30.0, 13.0 } } };
  lms3dBorderLimits limits(region, 3, Reach);
  EXPECT_TRUE(limits.MayJoin(second, 0, 2));
  limits.Join(Lost, 0, 1);
  EXPECT_FALSE(limits.MayJoin(second, 0, 2));
  const lms3dCornerMerge merge = {
    { { 10.0, 10.0 }, { 30.0, 10.0 }, { 32.0, 10.0 }, { 40.0, 10.0 } }, { 30.0, 13.0 }
  };
  EXPECT_FALSE(limits.MayMerge(merge, { 0, 2, 1 }));
  EXPECT_TRUE(lms3dBorderLimits(region, 3, Reach).MayMerge(merge, { 0, 2, 1 }));
}

/// Merged edges share what the three before have cut off.
TEST(LMS3DBorderLimits, RememberWhatMergesCutOff)
{
  lms3dRegion region = MakeRegion();
  Set(&lms3dRegionBlock::Must, 20, 9, region);
  Set(&lms3dRegionBlock::Passed, 20, 6, region);
  const lms3dCornerMerge merge = { { { 10.0, 10.0 }, { 20.0, 8.0 }, { 24.0, 8.0 }, { 30.0, 10.0 } },
    { 22.0, 10.25 } };
  lms3dBorderLimits limits(region, 3, Reach);
  ASSERT_TRUE(limits.MayMerge(merge, { 0, 1, 2 }));
  limits.Merge(merge, { 0, 1, 2 });
  const Triangle away = { { { 10.0, 10.0 }, { 22.0, 10.25 }, { 30.0, 16.0 } } };
  EXPECT_FALSE(limits.MayJoin(away, 0, 1));
}
