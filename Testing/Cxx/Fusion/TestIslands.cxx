// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which islands of a region are joined.
 */
#include "Fusion/Outlines/lms3dIslands.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
void Fill(lms3dRegion::BitsOf bits, std::int32_t left, std::int32_t right, std::int32_t bottom,
  std::int32_t top, lms3dRegion& region)
{
  for (std::int32_t v = bottom; v <= top; ++v)
  {
    region.SetRow(bits, v, left, right, true, true, [](int) {});
  }
}

/// Islands of 4 x 4 cells in a row, with gaps between them.
lms3dRegion MakeIslands(int count, int gap)
{
  lms3dRegion region;
  for (int i = 0; i < count; ++i)
  {
    const std::int32_t left = i * (4 + gap);
    Fill(&lms3dRegionBlock::May, left, left + 3, 10, 13, region);
  }
  return region;
}

bool Join(lms3dRegion& region, const lms3dRaster& raster = lms3dRaster(),
  const std::vector<lms3dCreaseLine>& creases = {})
{
  return lms3dJoinIslands(lms3dTraceOutlines(region), raster, creases, region);
}

std::size_t CountOutlines(const lms3dRegion& region)
{
  return lms3dTraceOutlines(region).size();
}
} // namespace

TEST(LMS3DIslands, AreJoinedIfTheyAreNear)
{
  lms3dRegion near = MakeIslands(4, 32);
  ASSERT_EQ(CountOutlines(near), 4U);
  EXPECT_TRUE(Join(near));
  EXPECT_EQ(CountOutlines(near), 1U);
  lms3dRegion far = MakeIslands(4, 33);
  EXPECT_FALSE(Join(far));
  EXPECT_EQ(CountOutlines(far), 4U);
}

/// A hole is no island, and one island has none to be joined with.
TEST(LMS3DIslands, StayAlone)
{
  lms3dRegion region;
  Fill(&lms3dRegionBlock::May, 0, 20, 0, 20, region);
  for (std::int32_t v = 8; v < 12; ++v)
  {
    region.SetRow(&lms3dRegionBlock::May, v, 8, 11, false, false, [](int) {});
  }
  EXPECT_FALSE(Join(region));
  EXPECT_EQ(CountOutlines(region), 2U);
}

TEST(LMS3DIslands, StayApartWhereBeamsPassed)
{
  lms3dRegion region = MakeIslands(3, 20);
  Fill(&lms3dRegionBlock::Passed, 12, 12, 0, 40, region);
  const lms3dRegion before = region;
  EXPECT_TRUE(Join(region));
  EXPECT_EQ(CountOutlines(region), 2U);
  for (std::int32_t v = 0; v <= 40; ++v)
  {
    EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 12, v));
    for (std::int32_t u = 0; u < 60; ++u)
    {
      EXPECT_GE(region.Has(&lms3dRegionBlock::May, u, v), before.Has(&lms3dRegionBlock::May, u, v));
    }
  }
}

/// Between the islands is a block that does not exist.
TEST(LMS3DIslands, StayApartWhereNothingIsKnown)
{
  lms3dRegion region;
  Fill(&lms3dRegionBlock::May, 60, 63, 60, 63, region);
  Fill(&lms3dRegionBlock::May, 64, 67, 70, 73, region);
  EXPECT_FALSE(Join(region));
  region.Make(0, 1);
  region.Make(1, 0);
  EXPECT_TRUE(Join(region));
  EXPECT_EQ(CountOutlines(region), 1U);
}

/// The islands have one corner in common. A beam may have passed through one of the two cells
/// beside it.
TEST(LMS3DIslands, AreJoinedIfTheyTouch)
{
  for (const std::int32_t bottom : { 6, 14 })
  {
    lms3dRegion region;
    Fill(&lms3dRegionBlock::May, 10, 13, 10, 13, region);
    Fill(&lms3dRegionBlock::May, 14, 17, bottom, bottom + 3, region);
    lms3dRegion passed = region;
    Fill(&lms3dRegionBlock::Passed, 13, 13, bottom == 6 ? 9 : 14, bottom == 6 ? 9 : 14, passed);
    EXPECT_FALSE(Join(passed));
    ASSERT_EQ(CountOutlines(region), 2U);
    EXPECT_TRUE(Join(region));
    EXPECT_EQ(CountOutlines(region), 1U);
  }
}

TEST(LMS3DIslands, StayApartBetweenBeamsThatAllPassed)
{
  lms3dRegion region = MakeIslands(3, 20);
  lms3dRaster raster;
  raster.Make(0, 0);
  lms3dCellStrip open;
  open.Row = 0;
  for (int row = 0; row < 40; ++row)
  {
    open.Add(12, 12);
  }
  raster.Open(open);
  EXPECT_TRUE(Join(region, raster));
  EXPECT_EQ(CountOutlines(region), 2U);
}

/// A crease between the first two of three islands. It ends in front of the islands, behind them,
/// or is beside them.
TEST(LMS3DIslands, StayApartAtCreases)
{
  const auto count = [](double place, double first, double last)
  {
    lms3dRegion region = MakeIslands(3, 20);
    lms3dCreaseLine crease;
    crease.Point = { place, 0.0 };
    crease.Direction = { 0.0, 1.0 };
    crease.Parts.Drawn = { { first, last } };
    EXPECT_TRUE(Join(region, lms3dRaster(), { crease }));
    return CountOutlines(region);
  };
  EXPECT_EQ(count(12.0, 0.0, 30.0), 2U);
  EXPECT_EQ(count(12.0, 20.0, 30.0), 1U);
  EXPECT_EQ(count(12.0, -30.0, 5.0), 1U);
  EXPECT_EQ(count(-3.0, 0.0, 30.0), 1U);
  EXPECT_EQ(count(4.0, 0.0, 30.0), 1U) << "the first island ends on the crease";
}
