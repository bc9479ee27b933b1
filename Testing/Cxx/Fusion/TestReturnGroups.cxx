// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the planes that are found in returns of several scans.
 */
#include "Fusion/Scans/lms3dReturnGroups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
constexpr double Bound = 0.009;

lms3dMappedReturn MakeReturn(const lms3dVector& point, const lms3dVector& direction)
{
  lms3dMappedReturn mapped;
  mapped.Point = point;
  mapped.Direction = lms3dNormalize(direction);
  mapped.Range = 2.0;
  mapped.BeamId = 0;
  mapped.Triangle = 0;
  return mapped;
}

/// Returns from two sides of a square post, 4 cm wide and 50 cm high, which both scans see.
std::vector<lms3dMappedReturn> SeePost()
{
  std::vector<lms3dMappedReturn> returns;
  for (int row = 0; row < 20; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      const double along = 0.005 + 0.01 * column;
      const double height = 0.0251 * row;
      returns.push_back(MakeReturn({ 0.0, along, height }, { -1.0, -0.7, 0.0 }));
      returns.push_back(MakeReturn({ -along, 0.04, height + 0.003 }, { -0.6, -1.0, 0.1 }));
    }
  }
  return returns;
}

double GetDistance(const lms3dReturnGroup& group, const lms3dVector& point)
{
  return std::abs(lms3dDot(group.Normal, lms3dSubtract(point, group.Centre)));
}
} // namespace

TEST(LMS3DReturnGroups, AreTheSidesOfAPost)
{
  const std::vector<lms3dMappedReturn> returns = SeePost();
  const std::vector<lms3dReturnGroup> groups = lms3dGroupReturns(returns, Bound);
  ASSERT_EQ(groups.size(), 2U);
  std::vector<int> counts(returns.size());
  for (const lms3dReturnGroup& group : groups)
  {
    EXPECT_GT(std::max(group.Normal[0], group.Normal[1]), 0.999);
    EXPECT_LT(group.Deviation, 0.1 * Bound);
    for (const int i : group.Returns)
    {
      ++counts[i];
      EXPECT_LE(GetDistance(group, returns[i].Point), Bound);
      EXPECT_LT(lms3dDot(group.Normal, returns[i].Direction), 0.0);
    }
  }
  EXPECT_EQ(counts, std::vector<int>(returns.size(), 1));
}

TEST(LMS3DReturnGroups, AreAcrossTheBeamsAtALine)
{
  constexpr int Count = 10;
  std::vector<lms3dMappedReturn> returns;
  returns.reserve(Count);
  for (int i = 0; i < Count; ++i)
  {
    returns.push_back(MakeReturn({ 1.0, 2.0, 0.05 * i }, { 0.6, 0.8, 0.3 }));
  }
  const std::vector<lms3dReturnGroup> groups = lms3dGroupReturns(returns, Bound);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].Returns.size(), returns.size());
  EXPECT_NEAR(groups[0].Normal[0], -0.6, 1e-6);
  EXPECT_NEAR(groups[0].Normal[1], -0.8, 1e-6);
  EXPECT_NEAR(groups[0].Normal[2], 0.0, 1e-6);
}

TEST(LMS3DReturnGroups, HaveNoReturnFromBehind)
{
  std::vector<lms3dMappedReturn> returns = SeePost();
  const std::size_t before = returns.size();
  for (int i = 0; i < 3; ++i)
  {
    returns.push_back(MakeReturn({ 0.0, 0.01 * i + 0.007, 0.1 * i * i }, { 1.0, 0.0, 0.0 }));
  }
  for (const lms3dReturnGroup& group : lms3dGroupReturns(returns, Bound))
  {
    for (const int i : group.Returns)
    {
      EXPECT_LT(lms3dDot(group.Normal, returns[i].Direction), 0.0);
      const bool isOfPost = i < static_cast<int>(before);
      EXPECT_EQ(isOfPost, group.Normal[0] > -0.5) << i;
    }
  }
}

TEST(LMS3DReturnGroups, AreNoneForTwoReturns)
{
  const std::vector<lms3dMappedReturn> returns = { MakeReturn(
                                                     { 0.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }),
    MakeReturn({ 0.0, 0.1, 0.0 }, { -1.0, 0.0, 0.0 }) };
  EXPECT_TRUE(lms3dGroupReturns(returns, Bound).empty());
  EXPECT_TRUE(lms3dGroupReturns({}, Bound).empty());
}
