// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks where outlines cross, and that creases are left out there alone.
 */
#include "Fusion/Outlines/lms3dOutlineCrossings.h"
#include "Fusion/Outlines/lms3dRegionTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
const lms3dLoop Square = { { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 10.0 }, { 0.0, 10.0 } };

using Points = std::vector<lms3dPoint2>;
} // namespace

TEST(LMS3DOutlineCrossings, AreNoneInOutlinesThatAreApart)
{
  EXPECT_TRUE(lms3dFindCrossings({}).empty());
  EXPECT_TRUE(lms3dFindCrossings({ Square }).empty());
  EXPECT_TRUE(
    lms3dFindCrossings({ Square, { { 20.0, 1.0 }, { 30.0, 1.0 }, { 25.0, 5.0 } } }).empty());
}

TEST(LMS3DOutlineCrossings, AreWhereEdgesCross)
{
  EXPECT_EQ(lms3dFindCrossings({ { { 0.0, 0.0 }, { 8.0, 8.0 }, { 8.0, 0.0 }, { 0.0, 8.0 } } }),
    (Points{ { 4.0, 4.0 } }));
}

/// Two edges meet in a corner.
TEST(LMS3DOutlineCrossings, AreCornersOnOtherEdges)
{
  EXPECT_EQ(lms3dFindCrossings({ Square, { { 5.0, 10.0 }, { 8.0, 14.0 }, { 2.0, 14.0 } } }),
    (Points{ { 5.0, 10.0 }, { 5.0, 10.0 } }));
}

TEST(LMS3DOutlineCrossings, AreTheEndsOfEqualEdges)
{
  const Points found =
    lms3dFindCrossings({ Square, { { 0.0, 10.0 }, { 10.0, 10.0 }, { 5.0, 14.0 } } });
  EXPECT_EQ(std::count(found.begin(), found.end(), lms3dPoint2{ 0.0, 10.0 }), 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), lms3dPoint2{ 10.0, 10.0 }), 1);
  EXPECT_EQ(found.size(), 2U);
}

TEST(LMS3DOutlineCrossings, AreSharedCornersIfNothingElse)
{
  EXPECT_EQ(lms3dFindCrossings({ Square, { { 10.0, 10.0 }, { 14.0, 12.0 }, { 12.0, 14.0 } } }),
    (Points{ { 10.0, 10.0 } }));
}

TEST(LMS3DOutlineCrossings, AreNoneOfLoopsWithoutArea)
{
  EXPECT_TRUE(lms3dFindCrossings({ Square, { { 5.0, 5.0 }, { 5.0, 15.0 } } }).empty());
  EXPECT_TRUE(lms3dFindCrossings({ Square, { { 0.0, 0.0 }, { 10.0, 10.0 } } }).empty());
  EXPECT_TRUE(lms3dFindCrossings({ Square, { { 10.0, 5.0 } } }).empty());
}

TEST(LMS3DOutlineCrossings, AreTheCornersOfEqualLoops)
{
  const std::vector<lms3dLoop> loops = { Square, Square };
  EXPECT_EQ(lms3dFindCrossingEdges(loops).size(), 8U);
  EXPECT_TRUE(lms3dTriangulateOutlines(loops));
}

/// Outlines may touch in corners, but have no triangles if their edges cross.
TEST(LMS3DOutlineCrossings, AreOfEdgesExactlyIfDifferentLoopsHaveNoTriangles)
{
  const auto expectCrossings = [](const std::vector<lms3dLoop>& loops, bool doCross)
  {
    EXPECT_EQ(!lms3dFindCrossingEdges(loops).empty(), doCross);
    EXPECT_EQ(!lms3dTriangulateOutlines(loops), doCross);
  };
  expectCrossings({ Square }, false);
  expectCrossings({ Square, { { 5.0, 5.0 }, { 5.0, 15.0 } } }, false);
  expectCrossings({ Square, { { 10.0, 10.0 }, { 14.0, 12.0 }, { 12.0, 14.0 } } }, false);
  expectCrossings({ Square, { { 5.0, 10.0 }, { 8.0, 14.0 }, { 2.0, 14.0 } } }, true);
  expectCrossings({ Square, { { 0.0, 10.0 }, { 10.0, 10.0 }, { 5.0, 14.0 } } }, true);
  expectCrossings({ Square, { { 5.0, 5.0 }, { 20.0, 5.0 }, { 20.0, 8.0 } } }, true);
}

/// Two strips of surface lie on both sides of a crease, so near to it that both move to it. Far
/// away the border follows the crease all the same.
TEST(LMS3DOutlineCrossings, LeaveCreasesOutNearby)
{
  lms3dRegion region;
  const auto fill = [&](
                      std::int32_t bottom, std::int32_t top, std::int32_t left, std::int32_t right)
  {
    for (std::int32_t v = bottom; v < top; ++v)
    {
      region.SetRow(&lms3dRegionBlock::May, v, left, right, true, true, [](int) {});
    }
  };
  fill(20, 59, 0, 600);
  fill(61, 100, 0, 60);
  const lms3dCreaseLine crease = { { 0.0, 60.25 }, { 1.0, 0.0 },
    { { { -10.0, 700.0 } }, { { -10.0, 700.0 } } } };
  const std::vector<lms3dTriangle2> triangles = lms3dTriangulateRegion(
    lms3dTraceOutlines(region), region, { crease }, lms3dFusedTile(0, 0), 9.0, 1.5);
  double area = 0.0;
  double farTop = 0.0;
  for (const lms3dTriangle2& t : triangles)
  {
    area +=
      ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])) / 2.0;
    for (const lms3dPoint2& corner : t)
    {
      farTop = corner[0] > 300.0 ? std::max(farTop, corner[1]) : farTop;
    }
  }
  EXPECT_LT(triangles.size(), 12U);
  EXPECT_NEAR(area, 601 * 40 + 61 * 40, 1000.0);
  EXPECT_DOUBLE_EQ(farTop, 60.25);
}
