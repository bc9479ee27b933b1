// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which holes of a region are closed.
 */
#include "Fusion/lms3dSmallHoles.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
void Set(lms3dRegion::BitsOf bits, std::int32_t left, std::int32_t right, std::int32_t bottom,
  std::int32_t top, bool value, lms3dRegion& region)
{
  for (std::int32_t v = bottom; v <= top; ++v)
  {
    region.SetRow(bits, v, left, right, value, true, [](int) {});
  }
}

/// Surface in the cells from 0 to 127 along both axes, with a hole that begins at cell 50, between
/// four blocks.
lms3dRegion MakeHole(std::int32_t width, std::int32_t height)
{
  lms3dRegion region;
  Set(&lms3dRegionBlock::May, 0, 127, 0, 127, true, region);
  Set(&lms3dRegionBlock::May, 50, 49 + width, 50, 49 + height, false, region);
  return region;
}

/// Returns whether a hole was closed. Expects the outlines that the region then has.
bool Close(lms3dRegion& region, const lms3dRaster& raster = lms3dRaster())
{
  std::vector<lms3dLoop> outlines = lms3dTraceOutlines(region);
  const std::size_t before = outlines.size();
  lms3dCloseSmallHoles(raster, outlines, region);
  EXPECT_EQ(outlines, lms3dTraceOutlines(region));
  return outlines.size() < before;
}

std::size_t CountOutlines(const lms3dRegion& region)
{
  return lms3dTraceOutlines(region).size();
}

std::size_t CountSurface(const lms3dRegion& region)
{
  std::size_t count = 0;
  for (std::int32_t v = -64; v < 192; ++v)
  {
    for (std::int32_t u = -64; u < 192; ++u)
    {
      count += region.Has(&lms3dRegionBlock::May, u, v) ? 1 : 0;
    }
  }
  return count;
}
} // namespace

TEST(LMS3DSmallHoles, AreClosed)
{
  struct Case
  {
    std::int32_t Width;
    std::int32_t Height;
    bool IsClosed;
  };
  for (const Case& each :
    { Case{ 1, 1, true }, { 32, 32, true }, { 33, 4, false }, { 4, 33, false } })
  {
    SCOPED_TRACE(testing::Message() << each.Width << " x " << each.Height);
    lms3dRegion region = MakeHole(each.Width, each.Height);
    const std::size_t before = CountSurface(region);
    EXPECT_EQ(Close(region), each.IsClosed);
    EXPECT_EQ(CountOutlines(region), each.IsClosed ? 1U : 2U);
    EXPECT_EQ(CountSurface(region), each.IsClosed ? 128U * 128U : before);
  }
}

/// A hole with the shape of a U.
TEST(LMS3DSmallHoles, HaveAnyShape)
{
  lms3dRegion region = MakeHole(30, 20);
  Set(&lms3dRegionBlock::May, 60, 69, 60, 69, true, region);
  EXPECT_TRUE(Close(region));
  EXPECT_EQ(CountOutlines(region), 1U);
  EXPECT_EQ(CountSurface(region), 128U * 128U);
}

/// Two holes touch at a corner, and another one touches the border.
TEST(LMS3DSmallHoles, CloseOneByOne)
{
  lms3dRegion region = MakeHole(10, 10);
  Set(&lms3dRegionBlock::May, 60, 100, 60, 65, false, region);
  Set(&lms3dRegionBlock::May, 1, 9, 1, 9, false, region);
  Set(&lms3dRegionBlock::May, 0, 0, 0, 0, false, region);
  Close(region);
  EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 0, 0));
  EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 80, 62));
}

TEST(LMS3DSmallHoles, StayAroundIslands)
{
  lms3dRegion region = MakeHole(20, 20);
  Set(&lms3dRegionBlock::May, 58, 60, 58, 60, true, region);
  EXPECT_FALSE(Close(region));
  EXPECT_EQ(CountOutlines(region), 3U);
}

TEST(LMS3DSmallHoles, StayWhereBeamsPassed)
{
  for (const std::int32_t cell : { 50, 63, 64, 69 })
  {
    lms3dRegion region = MakeHole(20, 20);
    Set(&lms3dRegionBlock::Passed, cell, cell, 66, 66, true, region);
    EXPECT_FALSE(Close(region));
    EXPECT_EQ(CountOutlines(region), 2U);
    EXPECT_EQ(CountSurface(region), 128U * 128U - 400U);
  }
}

/// A beam that passed beside the hole does not matter.
TEST(LMS3DSmallHoles, AreClosedBesideBeams)
{
  lms3dRegion region = MakeHole(20, 20);
  Set(&lms3dRegionBlock::Passed, 140, 140, 66, 66, true, region);
  EXPECT_TRUE(Close(region));
  EXPECT_EQ(CountOutlines(region), 1U);
}

TEST(LMS3DSmallHoles, StayBetweenBeamsThatPassed)
{
  lms3dRaster raster;
  raster.Make(1, 1);
  lms3dCellStrip strip;
  strip.Row = 66;
  strip.Add(64, 67);
  raster.Open(strip);
  lms3dRegion region = MakeHole(20, 20);
  EXPECT_FALSE(Close(region, raster));
  EXPECT_EQ(CountOutlines(region), 2U);
}

/// What lies around a region is no hole, even if it is small.
TEST(LMS3DSmallHoles, AreNotBesideARegion)
{
  lms3dRegion region;
  Set(&lms3dRegionBlock::May, 0, 9, 0, 9, true, region);
  Set(&lms3dRegionBlock::May, 4, 5, 4, 9, false, region);
  EXPECT_FALSE(Close(region));
  EXPECT_EQ(CountSurface(region), 88U);
}
