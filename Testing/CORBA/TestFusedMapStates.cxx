// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The states of the map of many scans, without a server.
#include "Scanning/lms3dFusedMapStore.h"
#include "Scanning/lms3dFusedRegions.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace
{
std::shared_ptr<const lms3dFusedRegion> MakeRegion(
  std::uint32_t id, std::uint64_t changed, bool isRemoved = false)
{
  lms3dFusedRegion region;
  region.Id = id;
  region.Changed = changed;
  if (!isRemoved)
  {
    region.Points = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    region.Triangles = { 0, 1, 2 };
  }
  return std::make_shared<const lms3dFusedRegion>(region);
}

std::vector<std::uint32_t> GetIds(const lms3dFusedRegions& regions)
{
  std::vector<std::uint32_t> ids;
  for (const auto& region : regions)
  {
    ids.push_back(region->Id);
  }
  return ids;
}

lms3dFusedMapState MakeState(std::uint64_t first, std::uint64_t number)
{
  lms3dFusedMapState state;
  state.Header.firstNumber = first;
  state.Header.number = number;
  return state;
}

using Ids = std::vector<std::uint32_t>;
} // namespace

TEST(FusedMapStates, ChangesHaveWhatIsNewerThanTheClient)
{
  lms3dFusedMapState state = MakeState(10, 12);
  state.Regions = { MakeRegion(1, 10), MakeRegion(2, 11), MakeRegion(3, 12, true),
    MakeRegion(4, 12) };
  EXPECT_EQ(GetIds(state.GetChanges(12)), Ids());
  EXPECT_EQ(GetIds(state.GetChanges(11)), (Ids{ 3, 4 }));
  EXPECT_EQ(GetIds(state.GetChanges(10)), (Ids{ 2, 3, 4 }));
  for (const std::uint64_t other : { 0, 9, 13 })
  {
    EXPECT_TRUE(state.IsWhole(other));
    EXPECT_EQ(GetIds(state.GetChanges(other)), (Ids{ 1, 2, 4 }));
  }
}

TEST(FusedMapStates, AClientThatIsTooFarBehindGetsTheWholeMap)
{
  const lms3dFusedMapState state = MakeState(1, 1 + lms3dFusedMapState::Memory);
  EXPECT_FALSE(state.IsWhole(1));
  EXPECT_TRUE(MakeState(1, 2 + lms3dFusedMapState::Memory).IsWhole(1));
}

TEST(FusedMapStates, NewRegionsReplaceOldOnes)
{
  lms3dFusedRegions regions = { MakeRegion(1, 1), MakeRegion(3, 1), MakeRegion(5, 1) };
  lms3dReplaceFusedRegions(
    { MakeRegion(0, 2), MakeRegion(3, 2, true), MakeRegion(6, 2) }, 2, regions);
  EXPECT_EQ(GetIds(regions), (Ids{ 0, 1, 3, 5, 6 }));
  EXPECT_TRUE(regions[2]->IsRemoved());
  EXPECT_EQ(regions[2]->Changed, 2U);
}

TEST(FusedMapStates, ARegionWithTheSameTrianglesIsNoChange)
{
  lms3dFusedRegions regions = { MakeRegion(1, 1), MakeRegion(3, 1) };
  lms3dReplaceFusedRegions({ MakeRegion(1, 2), MakeRegion(3, 2, true) }, 2, regions);
  EXPECT_EQ(regions[0]->Changed, 1U);
  EXPECT_EQ(regions[1]->Changed, 2U);
}

TEST(FusedMapStates, RemovedRegionsAreForgotten)
{
  lms3dFusedRegions regions = { MakeRegion(1, 1), MakeRegion(2, 3, true) };
  lms3dReplaceFusedRegions({}, 3 + lms3dFusedMapState::Memory, regions);
  EXPECT_EQ(GetIds(regions), (Ids{ 1, 2 }));
  lms3dReplaceFusedRegions({}, 4 + lms3dFusedMapState::Memory, regions);
  EXPECT_EQ(GetIds(regions), Ids{ 1 });
}

TEST(FusedMapStates, TheNewestAreKept)
{
  lms3dFusedMapStore store(3);
  EXPECT_FALSE(store.GetNewest());
  EXPECT_EQ(store.GetOldestNumber(), 0U);
  for (std::uint64_t number = 7; number < 12; ++number)
  {
    store.Publish(std::make_shared<const lms3dFusedMapState>(MakeState(7, number)));
  }
  EXPECT_EQ(store.GetOldestNumber(), 9U);
  EXPECT_EQ(store.GetNewestNumber(), 11U);
  EXPECT_FALSE(store.Find(8));
  EXPECT_FALSE(store.Find(12));
  EXPECT_EQ(store.Find(10)->Header.number, 10U);
}

TEST(FusedMapStates, FewerAreKeptIfTheyAreLarge)
{
  lms3dFusedMapState state = MakeState(1, 1);
  state.Regions = { MakeRegion(1, 1) };
  lms3dFusedMapStore store(10, 2 * state.GetBytes() - 1);
  for (std::uint64_t number = 1; number < 4; ++number)
  {
    state.Header.number = number;
    state.Regions = { MakeRegion(1, number) };
    store.Publish(std::make_shared<const lms3dFusedMapState>(state));
    EXPECT_EQ(store.GetOldestNumber(), number);
  }
}
