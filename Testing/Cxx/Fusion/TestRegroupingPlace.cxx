// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which planes of a place go or stay together.
 */
#include "Fusion/Returns/lms3dRegroupingPlace.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace
{
/// Returns whose beams have the numbers from `first` on.
std::vector<lms3dMappedReturn> MakeReturns(int first, int count)
{
  std::vector<lms3dMappedReturn> returns(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    returns[i].BeamId = first + i;
  }
  return returns;
}

std::vector<int> GetBeams(const lms3dRegroupingPlace& place, const std::vector<int>& returns)
{
  std::vector<int> beams;
  beams.reserve(returns.size());
  for (const int i : returns)
  {
    beams.push_back(place.Returns[i].BeamId);
  }
  return beams;
}

/// Four planes with three returns each. Two groups have returns of one plane, one of two planes,
/// and the last plane has no group.
lms3dRegroupingPlace MakePlace()
{
  lms3dRegroupingPlace place;
  place.AddOldPlane(17, MakeReturns(0, 3));
  place.AddOldPlane(4, MakeReturns(10, 3));
  place.AddOldPlane(9, MakeReturns(20, 3));
  place.AddOldPlane(2, MakeReturns(30, 3));
  for (const std::vector<int>& returns :
    { std::vector<int>{ 3, 4 }, std::vector<int>{ 8, 0, 1 }, std::vector<int>{ 5 } })
  {
    place.Groups.push_back({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 0.0, returns });
  }
  place.FindLeft();
  return place;
}
} // namespace

TEST(LMS3DRegroupingPlace, LeavesReturnsWithoutGroup)
{
  const lms3dRegroupingPlace place = MakePlace();
  EXPECT_EQ(place.Left, (std::vector<int>{ 2, 6, 7, 9, 10, 11 }));
}

TEST(LMS3DRegroupingPlace, IsSplitWherePlanesHaveNoGroupInCommon)
{
  const std::vector<lms3dRegroupingPlace> parts = MakePlace().Split();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].OldPlanes, (std::vector<int>{ 17, 9 }));
  EXPECT_EQ(parts[0].OwnerOf, (std::vector<std::size_t>{ 0, 0, 0, 1, 1, 1 }));
  ASSERT_EQ(parts[0].Groups.size(), 1U);
  EXPECT_EQ(GetBeams(parts[0], parts[0].Groups[0].Returns), (std::vector<int>{ 22, 0, 1 }));
  EXPECT_EQ(GetBeams(parts[0], parts[0].Left), (std::vector<int>{ 2, 20, 21 }));
  EXPECT_EQ(parts[1].OldPlanes, std::vector<int>{ 4 });
  ASSERT_EQ(parts[1].Groups.size(), 2U);
  EXPECT_EQ(GetBeams(parts[1], parts[1].Groups[0].Returns), (std::vector<int>{ 10, 11 }));
  EXPECT_EQ(GetBeams(parts[1], parts[1].Groups[1].Returns), std::vector<int>{ 12 });
  EXPECT_TRUE(parts[1].Left.empty());
  EXPECT_EQ(parts[2].OldPlanes, std::vector<int>{ 2 });
  EXPECT_TRUE(parts[2].Groups.empty());
  EXPECT_EQ(GetBeams(parts[2], parts[2].Left), (std::vector<int>{ 30, 31, 32 }));
}

/// A part keeps the order of all that it has.
TEST(LMS3DRegroupingPlace, StaysWholeIfAGroupHasReturnsOfAllPlanes)
{
  lms3dRegroupingPlace place = MakePlace();
  place.Groups[1].Returns = { 8, 0, 1, 3, 11 };
  place.Left.clear();
  place.FindLeft();
  const std::vector<lms3dRegroupingPlace> parts = place.Split();
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].OldPlanes, place.OldPlanes);
  EXPECT_EQ(parts[0].OwnerOf, place.OwnerOf);
  EXPECT_EQ(parts[0].Left, place.Left);
  ASSERT_EQ(parts[0].Groups.size(), 3U);
  EXPECT_EQ(parts[0].Groups[1].Returns, place.Groups[1].Returns);
}
