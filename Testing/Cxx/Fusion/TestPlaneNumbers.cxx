// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks when the number of a plane that went is used again, and that nothing of the old plane
 * stays.
 */
#include "Fusion/FusionFixtures.h"
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/lms3dGrowingMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr double Bound = 0.01;

lms3dMappedReturn MakeReturn(double x)
{
  lms3dMappedReturn mapped;
  mapped.Point = { x, 0.0, 1.0 };
  mapped.Direction = { 0.0, 0.0, -1.0 };
  mapped.Range = 2.0;
  mapped.BeamId = 0;
  mapped.Triangle = 0;
  mapped.Scan = 0;
  return mapped;
}

/// The planes that went.
std::set<std::size_t> FindGone(const lms3dFusedPlanes& planes)
{
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < planes.GetSize(); ++i)
  {
    if (planes[i].HasGone)
    {
      found.insert(i);
    }
  }
  return found;
}
} // namespace

TEST(LMS3DPlaneNumbers, AreUsedAgainWhenMeshesAreUpToDate)
{
  lms3dFusedPlanes planes(Bound);
  for (int i = 0; i < 4; ++i)
  {
    planes.AddFacet(MakeReturn(i));
  }
  planes[1].Creases[3] = {};
  planes[3].Creases[1] = {};
  for (const int number : { 2, 0, 1 })
  {
    planes.Clear(number);
  }
  planes.AddFacet(MakeReturn(4.0));
  EXPECT_EQ(planes.GetSize(), 5U) << "the tiles of the old planes may have triangles";
  planes.ReuseNumbers();
  EXPECT_EQ(planes.MakePlane({ 0.0, 0.0, 2.0 }, { 1.0, 0.0, 0.0 }), 0);
  EXPECT_EQ(planes.MakePlane({ 0.0, 0.0, 2.0 }, { 1.0, 0.0, 0.0 }), 2);
  EXPECT_EQ(planes.MakePlane({ 0.0, 0.0, 2.0 }, { 1.0, 0.0, 0.0 }), 5) << "1 has a crease";
}

/// 1 has creases with 0 and 2. 0 has one with 3, too, which stays.
TEST(LMS3DPlaneNumbers, AreUsedAgainWhenOtherPlanesAtCreasesHaveGone)
{
  lms3dFusedPlanes planes(Bound);
  for (int i = 0; i < 4; ++i)
  {
    planes.AddFacet(MakeReturn(i));
  }
  for (const auto& [first, second] :
    std::vector<std::pair<int, int>>{ { 0, 1 }, { 1, 2 }, { 0, 3 } })
  {
    planes[first].Creases[second] = {};
    planes[second].Creases[first] = {};
  }
  planes.Clear(1);
  planes.Clear(0);
  planes.ReuseNumbers();
  EXPECT_EQ(planes.GetNumberOfUnused(), 0U) << "2 has not gone";
  planes.Clear(2);
  planes.ReuseNumbers();
  EXPECT_EQ(planes.GetNumberOfUnused(), 2U);
  EXPECT_TRUE(planes[1].Creases.empty());
  EXPECT_TRUE(planes[2].Creases.empty());
  EXPECT_EQ(planes[0].Creases.size(), 1U);
  EXPECT_EQ(planes[3].Creases.size(), 1U);
  planes.Clear(3);
  planes.ReuseNumbers();
  EXPECT_EQ(planes.GetNumberOfUnused(), 4U);
}

/// The second tile was of an earlier plane of the number, and lost its triangles with this plane.
TEST(LMS3DPlaneNumbers, ChangeNoTilesWithoutTriangles)
{
  lms3dFusedPlanes planes(Bound);
  planes.AddFacet(MakeReturn(0.0));
  planes[0].Tiles.resize(3);
  planes[0].Tiles[0].Mesh.Triangles.resize(1);
  planes[0].Tiles[2].Blocks.push_back(0);
  for (lms3dFusedTile& tile : planes[0].Tiles)
  {
    tile.IsStale = false;
  }
  planes.Clear(0);
  EXPECT_TRUE(planes[0].Tiles[0].IsStale);
  EXPECT_FALSE(planes[0].Tiles[1].IsStale);
  EXPECT_TRUE(planes[0].Tiles[2].IsStale);
}

TEST(LMS3DPlaneNumbers, HaveNothingOfTheOldPlane)
{
  lms3dFusedPlanes planes(Bound);
  planes.AddFacet(MakeReturn(0.0));
  planes[0].IsCurved = true;
  planes[0].RegroupedTriangles = 7;
  planes.Clear(0);
  planes.ReuseNumbers();
  ASSERT_EQ(planes.MakePlane({ 0.0, 0.0, 2.0 }, { 1.0, 0.0, 0.0 }), 0);
  const lms3dFusedPlane& plane = planes[0];
  EXPECT_EQ(plane.Frame.GetNormal(), (lms3dVector{ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(plane.Raster.GetNumberOfBlocks(), 0);
  EXPECT_TRUE(plane.Returns.empty());
  EXPECT_TRUE(plane.Verbatim.empty());
  EXPECT_EQ(plane.RegroupedTriangles, 0U);
  EXPECT_FALSE(plane.IsWeak || plane.IsCurved || plane.HasGone || plane.HasSurface);
  lms3dWorldBox old;
  old.Add(MakeReturn(0.0).Point);
  EXPECT_TRUE(planes.FindPlanesNear(old, Bound).empty());
}

/// A new number is made only when no number can be used again.
TEST(LMS3DPlaneNumbers, AreNotMoreThanAMapNeeds)
{
  lms3dGrowingMap map({ Bound, true, false });
  std::size_t reused = 0;
  int grown = 0;
  for (const MappedScan& scan : ScanRoom())
  {
    const std::set<std::size_t> before = FindGone(map.GetPlanes());
    const std::size_t size = map.GetPlanes().GetSize();
    const std::size_t regions = map.GetRegions().size();
    ASSERT_TRUE(map.Add(scan.Map, scan.Scan, [](double) { return true; }));
    for (const std::size_t number : before)
    {
      reused += map.GetPlanes()[number].HasGone ? 0 : 1;
    }
    grown += map.GetPlanes().GetSize() > size ? 1 : 0;
    EXPECT_TRUE(map.GetPlanes().GetSize() == size || map.GetPlanes().GetNumberOfUnused() == 0);
    EXPECT_GE(map.GetRegions().size(), regions);
  }
  EXPECT_GT(reused, 0U);
  EXPECT_GT(grown, 1);
}
