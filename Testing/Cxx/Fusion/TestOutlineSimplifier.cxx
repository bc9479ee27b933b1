// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that outlines become simpler again after corners went or moved.
 */
#include "Fusion/Outlines/lms3dOutlineSimplifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
constexpr double Tolerance = 18.0;
constexpr double Reach = 0.9;

/// A square with a notch between two corners of its upper side, and a corner in the notch.
const lms3dLoop Notched = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 40.0 }, { 42.0, 38.0 },
  { 40.0, 39.0 }, { 22.0, 40.0 }, { 2.0, 40.0 } };
constexpr int InNotch = 4;

/// Takes the corner in the notch out, moves the one beside it, and simplifies what is left.
lms3dLoop SimplifyAgain(const lms3dPoint2& place)
{
  lms3dRegion region;
  region.Make(0, 0);
  lms3dOutlineCorners corners({ Notched }, std::vector<bool>(Notched.size(), false));
  corners.Remove(InNotch);
  corners.Move(InNotch - 1, place);
  lms3dBorderLimits limits(region, Notched.size(), Reach);
  lms3dOutlineSimplifier(Tolerance, corners, limits).Simplify();
  return corners.GetLoops().front();
}

/// Simplifies a square whose upper side has a notch between two corners that are fixed. `height` is
/// that of the first of them.
lms3dLoop SimplifyBesideNotch(double height)
{
  const lms3dLoop loop = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 40.0 }, { 42.0, height },
    { 32.0, 38.0 }, { 22.0, 40.0 }, { 2.0, 40.0 } };
  lms3dRegion region;
  region.Make(0, 0);
  lms3dOutlineCorners corners({ loop }, { false, false, true, true, false, true, true });
  lms3dBorderLimits limits(region, loop.size(), Reach);
  lms3dOutlineSimplifier(Tolerance, corners, limits).Simplify();
  return corners.GetLoops().front();
}

const lms3dLoop Square = { { 2.0, 2.0 }, { 62.0, 2.0 }, { 62.0, 40.0 }, { 2.0, 40.0 } };
} // namespace

/// The corner that went lies between the notch and the line that takes its place.
TEST(LMS3DOutlineSimplifier, PassesCornersThatWentBefore)
{
  EXPECT_EQ(SimplifyAgain(Notched[InNotch - 1]), Square);
}

/// Once the notch has gone, the fixed corners beside it lie on a straight line.
TEST(LMS3DOutlineSimplifier, TakesOutFixedCornersOfAStraightLine)
{
  EXPECT_EQ(SimplifyBesideNotch(40.0), Square);
}

TEST(LMS3DOutlineSimplifier, KeepsFixedCornersBesideALine)
{
  const lms3dLoop loop = SimplifyBesideNotch(40.1);
  EXPECT_EQ(std::count(loop.begin(), loop.end(), lms3dPoint2{ 42.0, 40.1 }), 1);
}

TEST(LMS3DOutlineSimplifier, TakesOutCornersThatMovedBefore)
{
  EXPECT_EQ(SimplifyAgain({ 42.0, 41.0 }), Square);
}
