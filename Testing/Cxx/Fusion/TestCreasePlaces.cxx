// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks to which crease a corner moves, and which corners stay.
 */
#include "Fusion/Outlines/lms3dCreasePlaces.h"
#include "Fusion/Outlines/lms3dCreaseSnapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
/// A level crease.
lms3dCreaseLine MakeCrease(double height)
{
  const lms3dCreaseParts parts = { { -1000.0, 1000.0 } };
  return { { 0.0, height }, { 1.0, 0.0 }, { parts, parts } };
}

const lms3dFusedTile Tile(0, 0);
} // namespace

/// Two planes that are nearly the same have nearly the same crease with a third one. A border does
/// not change between these.
TEST(LMS3DCreasePlaces, AreOnTheFirstOfCreasesThatAreNearlyTheSame)
{
  for (const double second : { 10.9, 11.4 })
  {
    for (const double height : { 9.0, 10.1, 10.8, 12.0 })
    {
      const lms3dPoint2 corner = { 50.0, height };
      const auto place =
        lms3dFindPlaceOnCrease(corner, { MakeCrease(10.0), MakeCrease(second) }, Tile);
      ASSERT_TRUE(place);
      EXPECT_EQ((*place)[1], 10.0);
    }
  }
}

TEST(LMS3DCreasePlaces, AreOnTheNearestOfOthers)
{
  const std::vector<lms3dCreaseLine> creases = { MakeCrease(10.0), MakeCrease(12.0) };
  const auto find = [&](double height) {
    return lms3dFindPlaceOnCrease({ 50.0, height }, creases, Tile).value_or(lms3dPoint2{});
  };
  EXPECT_EQ(find(10.9)[1], 10.0);
  EXPECT_EQ(find(11.1)[1], 12.0);
  EXPECT_FALSE(lms3dFindPlaceOnCrease({ 50.0, 30.0 }, creases, Tile));
}

/// The second of two like creases does not hide the one across them.
TEST(LMS3DCreasePlaces, AreWhereCreasesMeetBesideLikeOnes)
{
  const lms3dCreaseLine across = { { 53.0, 0.0 }, { 0.0, 1.0 }, MakeCrease(0.0).Parts };
  const auto place =
    lms3dFindPlaceOnCrease({ 50.0, 9.5 }, { MakeCrease(10.0), MakeCrease(10.5), across }, Tile);
  ASSERT_TRUE(place);
  EXPECT_DOUBLE_EQ((*place)[0], 53.0);
  EXPECT_DOUBLE_EQ((*place)[1], 10.0);
}

/// Creases of other parts of a plane spare no corner its place.
TEST(LMS3DCreasePlaces, DependOnCreasesNearTheOutlinesAlone)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-400.0, 400.0);
  int found = 0;
  for (int i = 0; i < 200; ++i)
  {
    std::vector<lms3dCreaseLine> creases;
    for (int crease = 0; crease < 40; ++crease)
    {
      const double angle = place(random);
      const double along = place(random);
      const lms3dCreaseParts parts = { { along, along + 60.0 } };
      creases.push_back({ { place(random), place(random) }, { std::cos(angle), std::sin(angle) },
        { parts, parts } });
    }
    const double u = place(random);
    const double v = place(random);
    const lms3dLoop loop = { { u, v }, { u + 50.0, v }, { u, v + 50.0 } };
    const std::vector<lms3dCreaseLine> near = lms3dFindCreasesNear({ loop }, creases);
    EXPECT_LT(near.size(), creases.size());
    for (const lms3dPoint2& corner : loop)
    {
      const auto expected = lms3dFindPlaceOnCrease(corner, creases, Tile);
      EXPECT_EQ(lms3dFindPlaceOnCrease(corner, near, Tile), expected);
      found += expected ? 1 : 0;
    }
  }
  EXPECT_GT(found, 20);
}

TEST(LMS3DCreaseSnapping, LetsCornersNearPlacesStay)
{
  const lms3dLoop loop = { { 0.0, 0.0 }, { 400.0, 0.0 }, { 400.0, 12.0 }, { 200.0, 12.0 },
    { 0.0, 12.0 } };
  for (const double distance : { 24.0, 250.0 })
  {
    std::vector<bool> isFixed;
    const lms3dLoop snapped = lms3dSnapToCreases(
      { loop }, { MakeCrease(13.0) }, lms3dRegion(), Tile, { { 400.0, 12.0 } }, distance, isFixed)
                                .front();
    EXPECT_EQ(snapped[2][1], 12.0);
    EXPECT_EQ(snapped[3][1], distance > 200.0 ? 12.0 : 13.0);
  }
}
