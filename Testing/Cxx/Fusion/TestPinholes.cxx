// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which cells of a region go at holes near its border, and that returns keep theirs.
 */
#include "Fusion/Outlines/lms3dPinholes.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace
{
/// The tile with the cells from -1024 to 1023.
const lms3dFusedTile Tile(0, 0);

void Set(lms3dRegion::BitsOf bits, std::int32_t u, std::int32_t v, bool value, lms3dRegion& region)
{
  region.SetRow(bits, v, u, u, value, true, [](int) {});
}

void Pass(std::int32_t u, std::int32_t v, lms3dRegion& region)
{
  Set(&lms3dRegionBlock::Passed, u, v, true, region);
  Set(&lms3dRegionBlock::May, u, v, false, region);
}

/// Surface in the cells from 10 to 100 along both axes.
lms3dRegion MakeSquare()
{
  lms3dRegion region;
  for (std::int32_t v = 10; v <= 100; ++v)
  {
    region.SetRow(&lms3dRegionBlock::May, v, 10, 100, true, true, [](int) {});
  }
  return region;
}
} // namespace

TEST(LMS3DPinholes, JoinTheOutside)
{
  lms3dRegion region = MakeSquare();
  for (std::int32_t v = 20; v <= 60; v += 8)
  {
    Pass(12, v, region);
  }
  EXPECT_EQ(lms3dTraceOutlines(region).size(), 7U);
  lms3dOpenPinholes(Tile, region);
  EXPECT_EQ(lms3dTraceOutlines(region).size(), 1U);
  EXPECT_TRUE(region.Has(&lms3dRegionBlock::May, 13, 20));
}

TEST(LMS3DPinholes, StayIfFarFromTheOutside)
{
  lms3dRegion region = MakeSquare();
  Pass(15, 50, region);
  lms3dOpenPinholes(Tile, region);
  EXPECT_EQ(lms3dTraceOutlines(region).size(), 2U);
}

TEST(LMS3DPinholes, StayBehindReturns)
{
  lms3dRegion region = MakeSquare();
  Pass(12, 50, region);
  Set(&lms3dRegionBlock::Must, 10, 50, true, region);
  lms3dOpenPinholes(Tile, region);
  EXPECT_EQ(lms3dTraceOutlines(region).size(), 2U);
}

TEST(LMS3DPinholes, TakeIslandsWithoutReturns)
{
  for (const bool hasReturn : { false, true })
  {
    lms3dRegion region = MakeSquare();
    // A gap that no beam passed, between two holes, leaves four columns of the border.
    Pass(14, 20, region);
    Pass(14, 30, region);
    for (std::int32_t v = 21; v < 30; ++v)
    {
      Set(&lms3dRegionBlock::May, 14, v, false, region);
    }
    Set(&lms3dRegionBlock::Must, 11, 25, hasReturn, region);
    lms3dOpenPinholes(Tile, region);
    EXPECT_EQ(region.Has(&lms3dRegionBlock::May, 11, 25), hasReturn);
  }
}

TEST(LMS3DPinholes, DoNotJoinAnotherTile)
{
  lms3dRegion region;
  for (std::int32_t v = 0; v <= 60; ++v)
  {
    region.SetRow(&lms3dRegionBlock::May, v, 900, 1023, true, true, [](int) {});
  }
  Pass(1022, 30, region);
  lms3dOpenPinholes(Tile, region);
  EXPECT_TRUE(region.Has(&lms3dRegionBlock::May, 1023, 30));
}
