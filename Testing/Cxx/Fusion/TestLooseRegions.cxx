// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which returns go to the triangles of other planes, and which facets go with them.
 */
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Returns/lms3dHandedReturns.h"
#include "Fusion/Returns/lms3dLooseRegions.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace
{
constexpr double Bound = 0.01;
constexpr int Revision = 3;

/// A return of a beam that goes down at 45 degrees towards -x.
lms3dMappedReturn MakeReturn(const lms3dVector& point)
{
  lms3dMappedReturn mapped;
  mapped.Point = point;
  mapped.Direction = lms3dNormalize({ -1.0, 0.0, -1.0 });
  mapped.Range = 2.0;
  mapped.BeamId = 0;
  mapped.Triangle = 0;
  mapped.Scan = 0;
  return mapped;
}

/// Lets triangles of a plane cover the cell of a return, in a block that exists.
void Cover(int number, const lms3dMappedReturn& mapped, lms3dFusedPlanes& planes)
{
  lms3dFusedPlane& plane = planes[number];
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const std::int32_t u = lms3dGetCellOf(place[0]);
  const std::int32_t v = lms3dGetCellOf(place[1]);
  plane.Raster.Make(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v));
  plane.Raster.Set(&lms3dRasterBlock::Covered, lms3dMakeCellStrip(u, v), true);
  planes.GrowBox(number, mapped.Point);
}

bool Has(lms3dRaster::BitsOf bits, const lms3dMappedReturn& mapped, const lms3dFusedPlane& plane)
{
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  return plane.Raster.Has(bits, lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]));
}

/// Adds a facet around a return, with one triangle. Returns its number.
int AddLooseRegion(const lms3dMappedReturn& mapped, lms3dFusedPlanes& planes)
{
  planes.AddFacet(mapped);
  const auto number = static_cast<int>(planes.GetSize()) - 1;
  planes[number].Tiles.emplace_back();
  lms3dFusedTile& tile = planes[number].Tiles.front();
  tile.Mesh.Triangles.resize(1);
  tile.Revision = Revision;
  tile.Blocks.push_back(0);
  return number;
}

int AddWall(lms3dFusedPlanes& planes)
{
  return planes.MakePlane({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
}

/// How many returns a weak plane keeps at most.
int FindLargestWeakCount()
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.0, 0.0, 0.0 });
  lms3dFusedPlanes planes(Bound);
  planes.AddFacet(mapped);
  int count = 0;
  while (planes[0].IsWeak)
  {
    planes.AddReturn(0, mapped);
    ++count;
  }
  return count;
}

/// A floor of few returns, and a wall that meets it at x = 0.
struct FloorAndWall
{
  FloorAndWall()
    : Floor(Planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }))
    , Wall(Planes.MakePlane({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }))
  {
    this->Planes[this->Floor].IsWeak = true;
    this->Planes[this->Floor].Tiles.emplace_back();
    this->Planes[this->Floor].Tiles.front().Revision = Revision;
    this->Planes[this->Floor].Tiles.front().Blocks.push_back(0);
    this->Planes[this->Floor].TiledBlocks = 1;
  }

  /// Adds a return to the floor, whose triangles cover it.
  void AddToFloor(const lms3dMappedReturn& mapped)
  {
    Cover(this->Floor, mapped, this->Planes);
    this->Planes.AddReturn(this->Floor, mapped);
  }

  lms3dFusedPlanes Planes{ Bound };
  const int Floor;
  const int Wall;
};

/// A facet whose return a loose region covers, and a wall that covers the region's own return.
struct LooseChain
{
  explicit LooseChain(bool isRegionFirst)
  {
    if (isRegionFirst)
    {
      this->Region = AddLooseRegion(this->OfRegion, this->Planes);
    }
    this->Facet = AddLooseRegion(this->OfFacet, this->Planes);
    if (!isRegionFirst)
    {
      this->Region = AddLooseRegion(this->OfRegion, this->Planes);
    }
    this->Wall = AddWall(this->Planes);
    Cover(this->Region, this->OfFacet, this->Planes);
    Cover(this->Wall, this->OfRegion, this->Planes);
  }

  const lms3dMappedReturn OfFacet = MakeReturn({ 0.001, 0.001, 0.004 });
  const lms3dMappedReturn OfRegion = MakeReturn({ 0.001, 0.021, 0.004 });
  lms3dFusedPlanes Planes{ Bound };
  int Facet = -1;
  int Region = -1;
  int Wall = -1;
};
} // namespace

TEST(LMS3DLooseRegions, GoIfOtherTrianglesCoverTheirReturns)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.001, 0.001, 0.004 });
  FloorAndWall scene;
  scene.Planes.AddFacet(mapped);
  const std::size_t facet = scene.Planes.GetSize() - 1;
  scene.Planes[facet].Tiles.emplace_back();
  scene.Planes[facet].Tiles.front().Mesh.Triangles.resize(1);
  lms3dDropLooseRegions(scene.Planes, 0);
  EXPECT_FALSE(scene.Planes[facet].HasGone);
  Cover(scene.Wall, mapped, scene.Planes);
  scene.Planes[scene.Wall].Tiles.emplace_back();
  scene.Planes[scene.Wall].Tiles.front().Blocks.push_back(0);
  scene.Planes[scene.Wall].Tiles.front().Revision = Revision;
  lms3dDropLooseRegions(scene.Planes, Revision + 1);
  EXPECT_FALSE(scene.Planes[facet].HasGone) << "no mesh changed";
  lms3dDropLooseRegions(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[facet].HasGone);
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, mapped, scene.Planes[scene.Wall]));
  EXPECT_FALSE(Has(&lms3dRasterBlock::Must, mapped, scene.Planes[scene.Wall]));
}

/// The region that covered the facet's return goes first.
TEST(LMS3DLooseRegions, GiveReturnsToPlanesThatStay)
{
  LooseChain scene(true);
  Cover(scene.Wall, scene.OfFacet, scene.Planes);
  lms3dDropLooseRegions(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Region].HasGone);
  EXPECT_TRUE(scene.Planes[scene.Facet].HasGone);
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, scene.OfRegion, scene.Planes[scene.Wall]));
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, scene.OfFacet, scene.Planes[scene.Wall]));
}

/// The facet goes first.
TEST(LMS3DLooseRegions, AreJudgedWithReturnsThatTheyGot)
{
  LooseChain scene(false);
  lms3dDropLooseRegions(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Facet].HasGone);
  EXPECT_FALSE(scene.Planes[scene.Region].HasGone)
    << "the wall does not cover the return of the facet";
  EXPECT_EQ(scene.Planes[scene.Region].Returns.size(), 2U);
  Cover(scene.Wall, scene.OfFacet, scene.Planes);
  lms3dDropLooseRegions(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Region].HasGone);
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, scene.OfRegion, scene.Planes[scene.Wall]));
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, scene.OfFacet, scene.Planes[scene.Wall]));
}

/// A region that has got too many returns is weak no more, and has no list of them. So it could not
/// give them to the wall that covers them.
TEST(LMS3DLooseRegions, StayIfTheyDoNotKeepTheirReturns)
{
  LooseChain scene(false);
  const int count = FindLargestWeakCount();
  for (int i = 1; i < count; ++i)
  {
    scene.Planes.AddReturn(scene.Region, scene.OfRegion);
  }
  ASSERT_TRUE(scene.Planes[scene.Region].IsWeak);
  lms3dDropLooseRegions(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Facet].HasGone);
  EXPECT_FALSE(scene.Planes[scene.Region].IsWeak);
  EXPECT_FALSE(scene.Planes[scene.Region].HasGone);
  EXPECT_TRUE(Has(&lms3dRasterBlock::Must, scene.OfRegion, scene.Planes[scene.Region]));
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, scene.OfFacet, scene.Planes[scene.Region]));
}

/// A later scan saw through the return of a region. The return of a facet comes to the same cell.
TEST(LMS3DLooseRegions, DropForgottenReturnsBeforeTheyGetOthers)
{
  const lms3dMappedReturn ofFacet = MakeReturn({ 0.001, 0.001, 0.004 });
  lms3dMappedReturn forgotten = ofFacet;
  forgotten.BeamId = 7;
  lms3dFusedPlanes planes(Bound);
  const int facet = AddLooseRegion(ofFacet, planes);
  const int region = AddLooseRegion(forgotten, planes);
  Cover(region, ofFacet, planes);
  const lms3dPoint2 place = planes[region].Frame.ToCells(forgotten.Point);
  planes[region].Raster.Forget(
    lms3dMakeCellStrip(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])));
  lms3dDropLooseRegions(planes, Revision);
  EXPECT_TRUE(planes[facet].HasGone);
  ASSERT_EQ(planes[region].Returns.size(), 1U);
  EXPECT_EQ(planes[region].Returns.front().BeamId, ofFacet.BeamId);
}

/// A triangle beside the foot of a return is within the bound of it if the return is near the
/// plane.
TEST(LMS3DFusedPlanes, CoverReturnsBesideTheirBorders)
{
  const double cell = Bound / 3.0;
  FloorAndWall scene;
  const auto covers = [&](double beyond, double height)
  {
    const lms3dMappedReturn mapped = MakeReturn({ height, 0.001, 0.5 * cell - beyond * cell });
    return scene.Planes.Covers(scene.Planes[scene.Wall], mapped);
  };
  EXPECT_FALSE(covers(0.0, 0.0));
  Cover(scene.Wall, MakeReturn({ 0.0, 0.001, 0.5 * cell }), scene.Planes);
  EXPECT_FALSE(covers(-1.0, 0.95 * Bound));
  EXPECT_TRUE(covers(0.0, 0.95 * Bound));
  for (const double side : { -1.0, 1.0 })
  {
    Cover(scene.Wall, MakeReturn({ 0.0, 0.001, 20.5 * cell }), scene.Planes);
    const auto coversBeside = [&](double beyond, double height)
    { return covers(-20.0 + side * beyond, height); };
    EXPECT_TRUE(coversBeside(2.0, 0.1 * Bound));
    EXPECT_FALSE(coversBeside(3.0, 0.1 * Bound));
    EXPECT_TRUE(coversBeside(1.0, 0.6 * Bound));
    EXPECT_FALSE(coversBeside(2.0, 0.6 * Bound));
    EXPECT_FALSE(coversBeside(1.0, 0.95 * Bound));
  }
}

TEST(LMS3DHandedReturns, GoToTheNearerPlane)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.0, 0.001, 0.005 });
  FloorAndWall scene;
  scene.AddToFloor(mapped);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_EQ(scene.Planes[scene.Floor].Returns.size(), 1U);
  Cover(scene.Wall, mapped, scene.Planes);
  lms3dHandReturnsOver(scene.Planes, Revision + 1);
  EXPECT_EQ(scene.Planes[scene.Floor].Returns.size(), 1U) << "the tile is of another revision";
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Floor].Returns.empty());
  EXPECT_TRUE(scene.Planes[scene.Floor].HasGone) << "the return was its last one";
  EXPECT_FALSE(Has(&lms3dRasterBlock::Must, mapped, scene.Planes[scene.Floor]));
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, mapped, scene.Planes[scene.Wall]));
}

TEST(LMS3DHandedReturns, ClearNoPlaneThatNeverHadAny)
{
  FloorAndWall scene;
  scene.Planes[scene.Floor].Raster.Make(0, 0);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_FALSE(scene.Planes[scene.Floor].HasGone);
}

/// The tile is of a plane that went and had the same number.
TEST(LMS3DHandedReturns, LeaveNewPlanesAtOnce)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.0, 0.001, 0.005 });
  FloorAndWall scene;
  scene.Planes[scene.Floor].Tiles.front().Blocks.clear();
  scene.Planes.AddReturn(scene.Floor, mapped);
  Cover(scene.Wall, mapped, scene.Planes);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_EQ(scene.Planes[scene.Floor].Returns.size(), 1U) << "the plane has blocks in tiles";
  scene.Planes[scene.Floor].TiledBlocks = 0;
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Floor].Returns.empty());
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, mapped, scene.Planes[scene.Wall]));
}

/// Later scans saw through the return.
TEST(LMS3DHandedReturns, AreNotThoseForgotten)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.0, 0.001, 0.005 });
  FloorAndWall scene;
  scene.AddToFloor(mapped);
  Cover(scene.Wall, mapped, scene.Planes);
  lms3dFusedPlane& floor = scene.Planes[scene.Floor];
  const lms3dPoint2 place = floor.Frame.ToCells(mapped.Point);
  floor.Raster.Forget(lms3dMakeCellStrip(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])));
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_TRUE(floor.Returns.empty());
  EXPECT_TRUE(floor.HasGone);
  EXPECT_FALSE(Has(&lms3dRasterBlock::Beside, mapped, scene.Planes[scene.Wall]));
}

TEST(LMS3DHandedReturns, StayIfAReturnOfTheirCellStays)
{
  const lms3dMappedReturn high = MakeReturn({ 0.0, 0.001, 0.005 });
  const lms3dMappedReturn low = MakeReturn({ 0.001, 0.001, 0.0 });
  FloorAndWall scene;
  scene.AddToFloor(high);
  scene.AddToFloor(low);
  Cover(scene.Wall, high, scene.Planes);
  Cover(scene.Wall, low, scene.Planes);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_EQ(scene.Planes[scene.Floor].Returns.size(), 2U);
  EXPECT_FALSE(scene.Planes[scene.Floor].HasGone);
  EXPECT_TRUE(Has(&lms3dRasterBlock::Must, high, scene.Planes[scene.Floor]));
}

/// The triangles of the floor are only a facet; then a triangle of the wall covers the return.
TEST(LMS3DHandedReturns, LeaveFacets)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.004, 0.001, 0.0 });
  FloorAndWall scene;
  scene.AddToFloor(mapped);
  Cover(scene.Wall, mapped, scene.Planes);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_EQ(scene.Planes[scene.Floor].Returns.size(), 1U);
  const lms3dPoint2 place = scene.Planes[scene.Floor].Frame.ToCells(mapped.Point);
  scene.Planes[scene.Floor].Tiles.front().Facets.push_back(
    { lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]) });
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Floor].Returns.empty());
  EXPECT_TRUE(Has(&lms3dRasterBlock::Beside, mapped, scene.Planes[scene.Wall]));
}

/// The floor is nearer to the return than the wall, but its facet goes with the return.
TEST(LMS3DHandedReturns, DoNotComeBackToFacets)
{
  const lms3dMappedReturn mapped = MakeReturn({ 0.004, 0.001, 0.0 });
  FloorAndWall scene;
  scene.AddToFloor(mapped);
  Cover(scene.Wall, mapped, scene.Planes);
  const lms3dPoint2 place = scene.Planes[scene.Floor].Frame.ToCells(mapped.Point);
  scene.Planes[scene.Floor].Tiles.front().Facets.push_back(
    { lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]) });
  scene.Planes[scene.Wall].IsWeak = true;
  scene.Planes[scene.Wall].Tiles.emplace_back();
  scene.Planes[scene.Wall].Tiles.front().Revision = Revision;
  scene.Planes[scene.Wall].Tiles.front().Blocks.push_back(0);
  lms3dHandReturnsOver(scene.Planes, Revision);
  EXPECT_TRUE(scene.Planes[scene.Floor].Returns.empty());
  EXPECT_FALSE(Has(&lms3dRasterBlock::Covered, mapped, scene.Planes[scene.Floor]));
  EXPECT_EQ(scene.Planes[scene.Wall].Returns.size(), 1U);
}
