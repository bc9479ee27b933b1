// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks when the number of a plane that went is used again, and that nothing of the old plane
 * stays.
 */
#include "Fusion/FusionFixtures.h"
#include "Fusion/lms3dFusedPlanes.h"
#include "Fusion/lms3dGrowingMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
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

/// The planes that went, whose numbers can be used again after the next scan.
std::set<std::size_t> FindReusable(const lms3dFusedPlanes& planes)
{
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < planes.GetSize(); ++i)
  {
    if (planes[i].HasGone && planes[i].Creases.empty())
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

/// A new number is made only when all others are in use, or have been since the last scan.
TEST(LMS3DPlaneNumbers, AreNotMoreThanAMapNeeds)
{
  lms3dGrowingMap map({ Bound, true, false });
  std::size_t reused = 0;
  for (const MappedScan& scan : ScanRoom())
  {
    const std::set<std::size_t> before = FindReusable(map.GetPlanes());
    const std::size_t size = map.GetPlanes().GetSize();
    const std::size_t regions = map.GetRegions().size();
    ASSERT_TRUE(map.Add(scan.Map, lms3dScanInput(scan.Scan), [](double) { return true; }));
    const std::set<std::size_t> after = FindReusable(map.GetPlanes());
    std::size_t used = 0;
    for (const std::size_t number : before)
    {
      used += after.count(number) == 0 ? 1 : 0;
    }
    reused += used;
    EXPECT_TRUE(map.GetPlanes().GetSize() == size || before.empty() || used > 0);
    EXPECT_GE(map.GetRegions().size(), regions);
  }
  EXPECT_GT(reused, 0U);
}
