// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which corners of outlines become one, and where the one lies.
 */
#include "Fusion/BorderFixtures.h"
#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Outlines/lms3dCornerMerger.h"
#include "Fusion/Outlines/lms3dCornerPlaces.h"
#include "Fusion/Outlines/lms3dOutlineSimplifier.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// Surface below row 100, and a saw with teeth of four cells above. Beams passed beside the upper
/// halves of the teeth and above them, and each tooth has returns in its middle.
lms3dRegion MakeSaw()
{
  lms3dRegion region;
  for (std::int32_t v = 0; v < 128; ++v)
  {
    for (std::int32_t u = 0; u < 256; ++u)
    {
      const bool isTooth = u / 8 % 2 == 0 && u >= 16 && u < 240;
      region.Make(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v));
      if (v < 100 || (isTooth && v < 104))
      {
        Set(&lms3dRegionBlock::May, u, v, region);
      }
      if (v == 105 || (v == 103 && !isTooth))
      {
        Set(&lms3dRegionBlock::Passed, u, v, region);
      }
      if ((v == 102 && isTooth) || (v == 90 && u % 8 == 4))
      {
        Set(&lms3dRegionBlock::Must, u, v, region);
      }
    }
  }
  return region;
}

std::vector<lms3dLoop> Straighten(
  const std::vector<lms3dLoop>& loops, const lms3dRegion& region, bool merges)
{
  std::size_t count = 0;
  for (const lms3dLoop& loop : loops)
  {
    count += loop.size();
  }
  lms3dOutlineCorners corners(loops, std::vector<bool>(count, false));
  lms3dBorderLimits limits(region, count, Reach);
  lms3dOutlineSimplifier(Tolerance, corners, limits).Simplify();
  if (merges)
  {
    lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  }
  return corners.GetLoops();
}

/// Cells of a square from 10 to 100 and 40, and beams that passed through a row above it.
lms3dRegion MakeSquareBelow(std::int32_t row)
{
  lms3dRegion region;
  for (std::int32_t u = 0; u < 128; ++u)
  {
    region.Make(lms3dRaster::GetBlockOf(u), 0);
    Set(&lms3dRegionBlock::Passed, u, row, region);
  }
  for (std::int32_t v = 10; v < 40; ++v)
  {
    region.SetRow(&lms3dRegionBlock::May, v, 10, 99, true, true, [](int) {});
  }
  return region;
}
} // namespace

TEST(LMS3DCornerMerger, MakesBordersBetweenReturnsAndBeamsStraight)
{
  const lms3dRegion region = MakeSaw();
  const std::vector<lms3dLoop> traced = lms3dTraceOutlines(region);
  ASSERT_EQ(traced.size(), 1U);
  const lms3dLoop simple = Straighten(traced, region, false).front();
  const lms3dLoop merged = Straighten(traced, region, true).front();
  EXPECT_GT(simple.size(), 20U);
  EXPECT_LE(merged.size(), 6U);
  ExpectLimitsKept(simple, region, Reach);
  ExpectLimitsKept(merged, region, Reach);
}

TEST(LMS3DCornerMerger, KeepsTheBorderOfBeamsThatPassedAllAround)
{
  lms3dRegion region = MakeSaw();
  for (std::int32_t u = 16; u < 240; ++u)
  {
    if (u / 8 % 2 == 0)
    {
      Set(&lms3dRegionBlock::Must, u, 103, region);
      Set(&lms3dRegionBlock::Far, u, 103, region);
    }
    else
    {
      Set(&lms3dRegionBlock::Passed, u, 101, region);
    }
  }
  const lms3dLoop merged = Straighten(lms3dTraceOutlines(region), region, true).front();
  EXPECT_GT(merged.size(), 40U);
  ExpectLimitsKept(merged, region, Reach);
}

TEST(LMS3DCornerMerger, KeepsFixedCorners)
{
  const lms3dRegion region = MakeSaw();
  const std::vector<lms3dLoop> loops = { { { 0.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 60.0 },
    { 150.0, 62.0 }, { 100.0, 60.0 }, { 50.0, 62.0 }, { 0.0, 60.0 } } };
  lms3dOutlineCorners corners(loops, std::vector<bool>(7, true));
  lms3dBorderLimits limits(region, 7, Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  EXPECT_EQ(corners.GetLoops(), loops);
}

/// The edges beside two corners meet far above, in the other outline and beyond the tile.
TEST(LMS3DCornerMerger, StaysApartFromOtherOutlinesAndInTheTile)
{
  lms3dRegion region;
  for (std::int32_t v = -17; v <= 17; ++v)
  {
    for (std::int32_t u = -17; u <= 17; ++u)
    {
      region.Make(u, v);
    }
  }
  const lms3dLoop cut = { { 900.0, 0.0 }, { 1023.0, 0.0 }, { 1023.0, 100.0 }, { 1022.0, 104.0 },
    { 904.0, 104.0 }, { 900.0, 100.0 } };
  const lms3dLoop above = { { 899.0, 104.5 }, { 905.0, 104.5 }, { 902.0, 110.0 } };
  for (const lms3dLoop& loop : { cut, above })
  {
    for (const lms3dPoint2& point : loop)
    {
      ASSERT_TRUE(Tile.Has(point));
    }
  }
  lms3dOutlineCorners corners({ cut, above }, std::vector<bool>(9, false));
  lms3dBorderLimits limits(region, 9, Reach);
  lms3dCornerMerger(1000.0, Tile, corners, limits).Merge();
  const std::vector<lms3dLoop> loops = corners.GetLoops();
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_LT(loops[0].size(), cut.size());
  EXPECT_EQ(loops[1].size(), above.size());
  for (int i = 0; i < 2; ++i)
  {
    for (const lms3dPoint2& point : loops[i])
    {
      EXPECT_TRUE(Tile.Has(point));
      EXPECT_FALSE(IsInside(point, loops[1 - i]));
      EXPECT_GT(GetDistance(point, loops[1 - i]), 0.0);
    }
  }
}

/// A border between returns and beams moves towards the beams.
TEST(LMS3DCornerMerger, MovesBordersOutwards)
{
  const lms3dRegion region = MakeSquareBelow(41);
  const lms3dLoop square = { { 10.0, 10.0 }, { 100.0, 10.0 }, { 100.0, 40.0 }, { 10.0, 40.0 } };
  lms3dOutlineCorners corners({ square }, { true, true, false, false });
  lms3dBorderLimits limits(region, 4, Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop loop = corners.GetLoops().front();
  ASSERT_EQ(loop.size(), square.size());
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(loop[i], square[i]);
    EXPECT_GT(loop[i + 2][1], 40.4);
    EXPECT_LT(loop[i + 2][1], 41.0);
  }
}

/// Beams passed right above the square. The corner at the upper right moves to the right alone.
TEST(LMS3DCornerMerger, MovesOneEdgeOutwardsIfTheOtherMustStay)
{
  const lms3dRegion region = MakeSquareBelow(40);
  const lms3dLoop square = { { 10.0, 10.0 }, { 100.0, 10.0 }, { 100.0, 39.75 }, { 10.0, 39.75 } };
  lms3dOutlineCorners corners({ square }, { true, true, false, true });
  lms3dBorderLimits limits(region, 4, Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop loop = corners.GetLoops().front();
  ASSERT_EQ(loop.size(), square.size());
  EXPECT_DOUBLE_EQ(loop[2][0], 102.0);
  EXPECT_DOUBLE_EQ(loop[2][1], 39.75);
}

TEST(LMS3DCornerPlaces, AreSharpIfTheRegionIsNarrow)
{
  const auto isSharp = [](double height, bool isReversed)
  {
    const lms3dPoint2 a = { 0.0, 0.0 };
    const lms3dPoint2 c = { 0.0, height };
    return lms3dIsSharpCorner({ isReversed ? c : a, { 100.0, height / 2.0 }, isReversed ? a : c });
  };
  EXPECT_TRUE(isSharp(10.0, false));
  EXPECT_FALSE(isSharp(14.0, false));
  EXPECT_FALSE(isSharp(10.0, true)) << "the region is around the corner";
}

TEST(LMS3DCornerPlaces, MoveBothEdgesOrOneOutwards)
{
  using Ways = std::vector<lms3dPoint2>;
  const auto expectWays = [](const std::array<lms3dPoint2, 3>& corners, const Ways& expected)
  {
    const Ways ways = lms3dFindWaysOutwards(corners);
    ASSERT_EQ(ways.size(), expected.size());
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      EXPECT_NEAR(ways[i][0], expected[i][0], 1e-12) << i;
      EXPECT_NEAR(ways[i][1], expected[i][1], 1e-12) << i;
    }
  };
  expectWays({ { { 0.0, 0.0 }, { 9.0, 0.0 }, { 9.0, 5.0 } } },
    { { 1.0, -1.0 }, { 1.0, 0.0 }, { 0.0, -1.0 } });
  expectWays({ { { 0.0, 0.0 }, { 9.0, 0.0 }, { 9.0, -5.0 } } },
    { { -1.0, -1.0 }, { -1.0, 0.0 }, { 0.0, -1.0 } });
  expectWays({ { { 0.0, 0.0 }, { 9.0, 0.0 }, { 12.0, 0.0 } } }, { { 0.0, -1.0 } });
  expectWays({ { { 0.0, 0.0 }, { 9.0, 0.0 }, { 4.0, 0.0 } } }, {});
  expectWays({ { { 0.0, 0.0 }, { 0.0, 0.0 }, { 4.0, 0.0 } } }, {});
}

/// The edges beside the upper corners meet 200 cells above them.
TEST(LMS3DCornerMerger, AddsNoSpikes)
{
  lms3dRegion region;
  for (std::int32_t v = -1; v < 8; ++v)
  {
    for (std::int32_t u = -1; u < 2; ++u)
    {
      region.Make(u, v);
    }
  }
  const lms3dLoop cut = { { 0.0, 0.0 }, { 30.0, 0.0 }, { 25.0, 100.0 }, { 5.0, 100.0 } };
  lms3dOutlineCorners corners({ cut }, { true, true, false, false });
  lms3dBorderLimits limits(region, 4, Reach);
  lms3dCornerMerger(Tolerance, Tile, corners, limits).Merge();
  const lms3dLoop merged = corners.GetLoops().front();
  for (const lms3dPoint2& point : merged)
  {
    EXPECT_LE(point[1], 100.0 + Tolerance);
  }
}

/// Borders without limits. Corners are merged again and again, so that an edge may be the only one
/// near corners that it did not replace.
TEST(LMS3DCornerMerger, StaysWithinTheToleranceOfTheFirstOutline)
{
  constexpr double Near = 3.0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const lms3dRegion region;
  for (int i = 0; i < 300; ++i)
  {
    lms3dLoop loop;
    for (int corner = 0; corner < 60; ++corner)
    {
      const double angle = 0.1047 * corner;
      const double radius = 60.0 + 4.0 * share(random);
      loop.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    lms3dOutlineCorners corners({ loop }, std::vector<bool>(loop.size(), false));
    lms3dBorderLimits limits(region, loop.size(), Reach);
    lms3dCornerMerger(Near, Tile, corners, limits).Merge();
    const lms3dLoop merged = corners.GetLoops().front();
    EXPECT_LT(merged.size(), loop.size());
    for (const lms3dPoint2& point : loop)
    {
      EXPECT_LE(GetDistance(point, merged), Near + 1e-9) << i;
    }
  }
}
