// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which islands of a region are joined.
 */
#include "Fusion/lms3dIslands.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

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

bool Join(lms3dRegion& region)
{
  return lms3dJoinIslands(lms3dTraceOutlines(region), region);
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
