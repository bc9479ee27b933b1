// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which holes of a region are closed.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"
#include "Fusion/Outlines/lms3dSmallHoles.h"
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Planes/lms3dRegionMesher.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
void Set(lms3dRegion::BitsOf bits, std::int32_t left, std::int32_t right, std::int32_t bottom,
  std::int32_t top, bool value, lms3dRegion& region)
{
  for (std::int32_t v = bottom; v <= top; ++v)
  {
    region.SetRow(bits, v, left, right, value, true, [](int) {});
  }
}

/// Surface in the cells from 0 to 127 along both axes, with a hole that begins at cell 50, between
/// four blocks.
lms3dRegion MakeHole(std::int32_t width, std::int32_t height)
{
  lms3dRegion region;
  Set(&lms3dRegionBlock::May, 0, 127, 0, 127, true, region);
  Set(&lms3dRegionBlock::May, 50, 49 + width, 50, 49 + height, false, region);
  return region;
}

/// Returns whether a hole was closed. Expects the outlines that the region then has.
bool Close(lms3dRegion& region, const lms3dRaster& raster = lms3dRaster())
{
  std::vector<lms3dLoop> outlines = lms3dTraceOutlines(region);
  const std::size_t before = outlines.size();
  lms3dCloseSmallHoles(raster, outlines, region);
  EXPECT_EQ(outlines, lms3dTraceOutlines(region));
  return outlines.size() < before;
}

std::size_t CountOutlines(const lms3dRegion& region)
{
  return lms3dTraceOutlines(region).size();
}

std::size_t CountSurface(const lms3dRegion& region)
{
  std::size_t count = 0;
  for (std::int32_t v = -64; v < 192; ++v)
  {
    for (std::int32_t u = -64; u < 192; ++u)
    {
      count += region.Has(&lms3dRegionBlock::May, u, v) ? 1 : 0;
    }
  }
  return count;
}

constexpr double Bound = 0.01;

/// A plane with surface in one block, which is its tile, with a hole of 20 x 20 cells.
class PlaneWithHole
{
public:
  PlaneWithHole()
    : Plane(Planes[Planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 })])
  {
    this->Plane.Tiles.emplace_back();
    this->Plane.Tiles.front().Blocks.push_back(this->Plane.Raster.Make(0, 0));
    this->Plane.Raster.GetBlock(0).Tile = 0;
    for (std::int32_t row = 5; row < 60; ++row)
    {
      const bool isBeside = row >= 20 && row < 40;
      this->SetShape(row, 5, isBeside ? 19 : 59);
      this->SetShape(row, isBeside ? 40 : 5, 59);
    }
  }

  void MakeMesh()
  {
    lms3dMakeTileMesh(this->Plane, this->Plane.Tiles.front(), {}, Bound);
    this->Plane.Raster.ClearMarks();
  }

  /// Whether triangles cover all cells of the hole.
  bool IsClosed() const
  {
    return this->Plane.Raster.HasAll(&lms3dRasterBlock::Covered, { 20, 39, 20, 39 });
  }
  lms3dRaster& GetRaster() { return this->Plane.Raster; }

private:
  void SetShape(std::int32_t row, std::int32_t first, std::int32_t last)
  {
    lms3dCellStrip strip;
    strip.Row = row;
    strip.Add(first, last);
    this->Plane.Raster.Set(&lms3dRasterBlock::Shape, strip, true);
  }

  lms3dFusedPlanes Planes{ Bound };
  lms3dFusedPlane& Plane;
};
} // namespace

TEST(LMS3DSmallHoles, AreClosed)
{
  struct Case
  {
    std::int32_t Width;
    std::int32_t Height;
    bool IsClosed;
  };
  for (const Case& each :
    { Case{ 1, 1, true }, { 32, 32, true }, { 33, 4, false }, { 4, 33, false } })
  {
    SCOPED_TRACE(testing::Message() << each.Width << " x " << each.Height);
    lms3dRegion region = MakeHole(each.Width, each.Height);
    const std::size_t before = CountSurface(region);
    EXPECT_EQ(Close(region), each.IsClosed);
    EXPECT_EQ(CountOutlines(region), each.IsClosed ? 1U : 2U);
    EXPECT_EQ(CountSurface(region), each.IsClosed ? 128U * 128U : before);
  }
}

/// A hole with the shape of a U.
TEST(LMS3DSmallHoles, HaveAnyShape)
{
  lms3dRegion region = MakeHole(30, 20);
  Set(&lms3dRegionBlock::May, 60, 69, 60, 69, true, region);
  EXPECT_TRUE(Close(region));
  EXPECT_EQ(CountOutlines(region), 1U);
  EXPECT_EQ(CountSurface(region), 128U * 128U);
}

TEST(LMS3DSmallHoles, CloseOneByOne)
{
  lms3dRegion region = MakeHole(10, 10);
  Set(&lms3dRegionBlock::May, 70, 110, 50, 59, false, region);
  EXPECT_TRUE(Close(region));
  EXPECT_TRUE(region.Has(&lms3dRegionBlock::May, 55, 55));
  EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 80, 55));
  EXPECT_EQ(CountOutlines(region), 2U);
}

/// Two holes touch at a corner. Both would be small enough alone, but not together.
TEST(LMS3DSmallHoles, CountAsOneIfTheyTouch)
{
  lms3dRegion region = MakeHole(10, 10);
  Set(&lms3dRegionBlock::May, 60, 89, 60, 65, false, region);
  EXPECT_FALSE(Close(region));
  EXPECT_EQ(CountOutlines(region), 2U);
}

/// One corner of the hole touches the border.
TEST(LMS3DSmallHoles, AreNotAtTheBorder)
{
  lms3dRegion region = MakeHole(10, 10);
  Set(&lms3dRegionBlock::May, 50, 59, 50, 59, true, region);
  Set(&lms3dRegionBlock::May, 1, 9, 1, 9, false, region);
  Set(&lms3dRegionBlock::May, 0, 0, 0, 0, false, region);
  EXPECT_FALSE(Close(region));
  EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 5, 5));
}

/// Coordinates whose squares are rounded.
TEST(LMS3DSmallHoles, AreClosedFarAway)
{
  constexpr std::int32_t Far = 1 << 30;
  lms3dRegion region;
  Set(&lms3dRegionBlock::May, Far, Far + 63, Far, Far + 63, true, region);
  Set(&lms3dRegionBlock::May, Far + 20, Far + 22, Far + 30, Far + 30, false, region);
  EXPECT_TRUE(Close(region));
  EXPECT_EQ(CountOutlines(region), 1U);
}

TEST(LMS3DSmallHoles, StayAroundIslands)
{
  lms3dRegion region = MakeHole(20, 20);
  Set(&lms3dRegionBlock::May, 58, 60, 58, 60, true, region);
  EXPECT_FALSE(Close(region));
  EXPECT_EQ(CountOutlines(region), 3U);
}

TEST(LMS3DSmallHoles, StayWhereBeamsPassed)
{
  for (const std::int32_t cell : { 50, 63, 64, 69 })
  {
    lms3dRegion region = MakeHole(20, 20);
    Set(&lms3dRegionBlock::Passed, cell, cell, 66, 66, true, region);
    EXPECT_FALSE(Close(region));
    EXPECT_EQ(CountOutlines(region), 2U);
    EXPECT_EQ(CountSurface(region), 128U * 128U - 400U);
  }
}

/// A beam that passed through another hole does not matter.
TEST(LMS3DSmallHoles, AreClosedBesideBeams)
{
  lms3dRegion region = MakeHole(20, 20);
  Set(&lms3dRegionBlock::May, 71, 74, 64, 68, false, region);
  Set(&lms3dRegionBlock::Passed, 72, 72, 66, 66, true, region);
  EXPECT_TRUE(Close(region));
  EXPECT_EQ(CountOutlines(region), 2U);
  EXPECT_TRUE(region.Has(&lms3dRegionBlock::May, 69, 66));
  EXPECT_FALSE(region.Has(&lms3dRegionBlock::May, 71, 66));
}

TEST(LMS3DSmallHoles, StayBetweenBeamsThatPassed)
{
  lms3dRaster raster;
  raster.Make(1, 1);
  lms3dCellStrip strip;
  strip.Row = 66;
  strip.Add(64, 67);
  raster.Open(strip);
  lms3dRegion region = MakeHole(20, 20);
  EXPECT_FALSE(Close(region, raster));
  EXPECT_EQ(CountOutlines(region), 2U);
}

/// What lies around a region is no hole, even if it is small.
TEST(LMS3DSmallHoles, AreNotBesideARegion)
{
  lms3dRegion region;
  Set(&lms3dRegionBlock::May, 0, 9, 0, 9, true, region);
  Set(&lms3dRegionBlock::May, 4, 5, 4, 9, false, region);
  EXPECT_FALSE(Close(region));
  EXPECT_EQ(CountSurface(region), 88U);
}

TEST(LMS3DSmallHoles, HaveTriangles)
{
  PlaneWithHole scene;
  scene.MakeMesh();
  EXPECT_TRUE(scene.IsClosed());
}

TEST(LMS3DSmallHoles, OpenWhereABeamPasses)
{
  PlaneWithHole scene;
  scene.MakeMesh();
  EXPECT_TRUE(scene.GetRaster().Has(&lms3dRasterBlock::Touched, 25, 25));
  scene.GetRaster().Pass(0, 25, 25);
  scene.MakeMesh();
  EXPECT_FALSE(scene.IsClosed());
  EXPECT_FALSE(scene.GetRaster().Has(&lms3dRasterBlock::Touched, 25, 25));
}

// A local map has surface there, but no return reaches it.
TEST(LMS3DSmallHoles, OpenOnGuessesBetweenBeamsThatPass)
{
  PlaneWithHole scene;
  scene.GetRaster().Set(&lms3dRasterBlock::May, lms3dMakeCellStrip(25, 25), true);
  scene.MakeMesh();
  EXPECT_TRUE(scene.IsClosed());
  scene.GetRaster().Open(lms3dMakeCellStrip(25, 25));
  EXPECT_TRUE(scene.GetRaster().HasMark(0, lms3dRaster::STALE));
}

TEST(LMS3DSmallHoles, OpenBetweenBeamsThatPass)
{
  PlaneWithHole scene;
  scene.MakeMesh();
  scene.GetRaster().Open(lms3dMakeCellStrip(50, 50));
  EXPECT_FALSE(scene.GetRaster().HasMark(0, lms3dRaster::STALE));
  scene.MakeMesh();
  EXPECT_TRUE(scene.IsClosed());
  scene.GetRaster().Open(lms3dMakeCellStrip(25, 25));
  EXPECT_TRUE(scene.GetRaster().HasMark(0, lms3dRaster::STALE));
  scene.MakeMesh();
  EXPECT_FALSE(scene.IsClosed());
  scene.GetRaster().Open(lms3dMakeCellStrip(30, 30));
  EXPECT_FALSE(scene.GetRaster().HasMark(0, lms3dRaster::STALE));
}

/// A plate before a hole in a wall hides it from the first pose, but not from the second one.
TEST(LMS3DSmallHoles, OpenWhereALaterScanSeesThrough)
{
  SceneBuilder scene;
  scene.AddBox({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 2.5 });
  const auto addWall = [&](double left, double right, double bottom, double top, double y) {
    scene.AddQuad({ left, y, bottom }, { right, y, bottom }, { right, y, top }, { left, y, top });
  };
  addWall(-3.0, -0.03, 0.0, 2.5, 1.0);
  addWall(0.03, 3.0, 0.0, 2.5, 1.0);
  addWall(-0.03, 0.03, 0.0, 1.17, 1.0);
  addWall(-0.03, 0.03, 1.23, 2.5, 1.0);
  addWall(-0.04, 0.04, 1.16, 1.24, 0.95);
  const MappedScan first = MakeMappedScan(scene.GetSurface(), { 0.0, -0.5, 1.2 }, false);
  const MappedScan second = MakeMappedScan(scene.GetSurface(), { 0.9, 0.5, 1.2 }, false);
  vtkNew<vtkLMS3DMapFusion> fusion;
  AddAll({ first }, fusion);
  fusion->Update();
  EXPECT_GT(JudgeFusion(fusion->GetOutput(), second, Bound).Blocked, 0);
  AddAll({ second }, fusion);
  fusion->Update();
  EXPECT_EQ(JudgeFusion(fusion->GetOutput(), { first, second }, Bound).Blocked, 0);
}
