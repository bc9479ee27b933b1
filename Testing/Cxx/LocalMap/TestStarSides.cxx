// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the border of the surface at a vertex.
 */
#include "LocalMap/Bounded/lms3dStarSides.h"

#include <gtest/gtest.h>

namespace
{
// The sides from one vertex to the next, from `first` to `last`.
lms3dStarSides MakeFan(int first, int last)
{
  lms3dStarSides sides;
  for (int vertex = first; vertex < last; ++vertex)
  {
    sides.Add(vertex, vertex + 1);
  }
  return sides;
}
} // namespace

TEST(StarSides, OfAFanEndAtItsEnds)
{
  for (int size : { 1, 6, 32, 33, 100 })
  {
    lms3dStarBorder border;
    EXPECT_TRUE(MakeFan(3, 3 + size).FindBorder(border)) << size;
    EXPECT_EQ(border.Next, 3);
    EXPECT_EQ(border.Last, 3 + size);
  }
}

TEST(StarSides, AroundAVertexHaveNoBorder)
{
  for (int size : { 2, 5, 31, 32, 90 })
  {
    lms3dStarSides sides = MakeFan(0, size);
    sides.Add(size, 0);
    lms3dStarBorder border;
    EXPECT_TRUE(sides.FindBorder(border)) << size;
    EXPECT_FALSE(border.IsOpen());
  }
}

TEST(StarSides, MustFollowEachOtherOnce)
{
  lms3dStarBorder border;
  EXPECT_FALSE(lms3dStarSides().FindBorder(border));
  EXPECT_FALSE(border.IsOpen());
  lms3dStarSides apart = MakeFan(0, 4);
  apart.Add(7, 8);
  EXPECT_FALSE(apart.FindBorder(border));
  lms3dStarSides withLoop = MakeFan(0, 4);
  withLoop.Add(10, 11);
  withLoop.Add(11, 10);
  EXPECT_FALSE(withLoop.FindBorder(border));
  lms3dStarSides twoLoops = MakeFan(0, 4);
  twoLoops.Add(4, 0);
  twoLoops.Add(10, 11);
  twoLoops.Add(11, 10);
  EXPECT_FALSE(twoLoops.FindBorder(border));
  EXPECT_FALSE(border.IsOpen());
}

TEST(StarSides, CountEachCommonVertexOnce)
{
  lms3dStarSides closed = MakeFan(0, 5);
  closed.Add(5, 0);
  EXPECT_EQ(closed.CountCommon(MakeFan(4, 8)), 2);
  EXPECT_EQ(MakeFan(4, 8).CountCommon(closed), 2);
  EXPECT_EQ(closed.CountCommon(MakeFan(20, 60)), 0);
  EXPECT_EQ(MakeFan(0, 40).CountCommon(MakeFan(10, 50)), 31);
}
