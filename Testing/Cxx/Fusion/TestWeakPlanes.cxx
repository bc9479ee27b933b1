// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which planes of a fused map go when better ones take their place.
 */
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Returns/lms3dWeakPlanes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
/// A return on the plane z = 1, seen from above, in column 10 i.
lms3dMappedReturn MakeReturn(int i)
{
  lms3dMappedReturn mapped;
  mapped.Point = { (10.0 * i + 0.5) * 0.01 / 3.0, 0.001, 1.0 };
  mapped.Direction = { 0.0, 0.0, -1.0 };
  mapped.Range = 2.0;
  mapped.BeamId = i;
  mapped.Triangle = 0;
  return mapped;
}

/// Lets a plane have surface at a return, then judges the weak planes.
void Grow(int number, const lms3dMappedReturn& mapped, lms3dFusedPlanes& planes)
{
  const lms3dPoint2 place = planes[number].Frame.ToCells(mapped.Point);
  planes[number].Raster.SetGuess(
    lms3dMakeCellStrip(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])));
  planes.GrowBox(number, mapped.Point);
  planes.AcceptGuesses(number);
}

bool HasReturn(const lms3dMappedReturn& mapped, const lms3dFusedPlane& plane)
{
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  return plane.Raster.Has(
    &lms3dRasterBlock::Must, lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]));
}

/// A weak plane with ten returns and some triangles, and a plane that shows six of the returns.
class WeakPlane
{
public:
  explicit WeakPlane(std::size_t triangles)
    : Weak(Planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }))
    , Other(Planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }))
  {
    this->Planes[this->Weak].IsWeak = true;
    this->Planes[this->Weak].Tiles.emplace_back();
    this->Planes[this->Weak].Tiles.front().Mesh.Triangles.resize(triangles);
    for (int i = 0; i < 10; ++i)
    {
      Grow(this->Weak, MakeReturn(i), this->Planes);
      this->Planes.AddReturn(this->Weak, MakeReturn(i));
    }
    for (int i = 0; i < 6; ++i)
    {
      Grow(this->Other, MakeReturn(i), this->Planes);
    }
  }

  lms3dFusedPlanes Planes{ 0.01 };
  const int Weak;
  const int Other;
};
} // namespace

TEST(LMS3DFusedPlanes, LoseFacetsWhereSurfaceGrows)
{
  const lms3dMappedReturn mapped = MakeReturn(0);
  lms3dFusedPlanes planes(0.01);
  planes.AddFacet(mapped);
  const int floor = planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  lms3dMappedReturn beside = mapped;
  beside.Point[0] += planes.GetCell();
  Grow(floor, beside, planes);
  lms3dDissolveWeakPlanes(planes);
  EXPECT_EQ(planes[0].Verbatim.size(), 1U);
  EXPECT_EQ(planes[0].Returns.size(), 1U);
  EXPECT_FALSE(HasReturn(mapped, planes[floor]));
  Grow(floor, mapped, planes);
  lms3dDissolveWeakPlanes(planes);
  EXPECT_TRUE(planes[0].HasGone);
  EXPECT_TRUE(planes[0].Verbatim.empty());
  EXPECT_EQ(planes[0].Raster.GetNumberOfBlocks(), 0);
  EXPECT_TRUE(HasReturn(mapped, planes[floor]));
  EXPECT_EQ(planes.GetSize(), 2U);
}

TEST(LMS3DFusedPlanes, StayIfFacetsWereMore)
{
  WeakPlane few(4);
  lms3dDissolveWeakPlanes(few.Planes);
  EXPECT_FALSE(few.Planes[few.Weak].HasGone);
  EXPECT_EQ(few.Planes.GetSize(), 2U);
}

/// Nearly all returns are shown, but the others would need more facets than the plane has
/// triangles.
TEST(LMS3DFusedPlanes, StayIfFacetsForFewOfManyReturnsWereMore)
{
  lms3dFusedPlanes planes(0.01);
  const int weak = planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  const int other = planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  planes[weak].IsWeak = true;
  planes[weak].Tiles.emplace_back();
  planes[weak].Tiles.front().Mesh.Triangles.resize(4);
  for (int i = 0; i < 100; ++i)
  {
    Grow(weak, MakeReturn(i), planes);
    planes.AddReturn(weak, MakeReturn(i));
  }
  for (int i = 0; i < 96; ++i)
  {
    Grow(other, MakeReturn(i), planes);
  }
  lms3dDissolveWeakPlanes(planes);
  EXPECT_FALSE(planes[weak].HasGone);
  Grow(other, MakeReturn(96), planes);
  lms3dDissolveWeakPlanes(planes);
  EXPECT_TRUE(planes[weak].HasGone);
  EXPECT_EQ(planes.GetSize(), 5U);
}

TEST(LMS3DFusedPlanes, GoIfFacetsAreFewer)
{
  WeakPlane many(5);
  lms3dDissolveWeakPlanes(many.Planes);
  EXPECT_TRUE(many.Planes[many.Weak].HasGone);
  EXPECT_TRUE(HasReturn(MakeReturn(5), many.Planes[many.Other]));
  ASSERT_EQ(many.Planes.GetSize(), 6U);
  for (std::size_t i = 2; i < 6; ++i)
  {
    EXPECT_EQ(many.Planes[i].Verbatim.size(), 1U);
  }
}

/// Returns that later scans saw through do not come back, and sightings keep their scans.
TEST(LMS3DFusedPlanes, TakeOverWhatIsNotForgotten)
{
  WeakPlane plane(5);
  lms3dFusedPlanes& planes = plane.Planes;
  const lms3dPoint2 place = planes[plane.Weak].Frame.ToCells(MakeReturn(9).Point);
  planes[plane.Weak].Raster.Forget(
    lms3dMakeCellStrip(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])));
  planes.SetScan(7);
  lms3dDissolveWeakPlanes(planes);
  EXPECT_TRUE(planes[plane.Weak].HasGone);
  EXPECT_EQ(planes.GetSize(), 5U);
  EXPECT_EQ(planes[plane.Other].Raster.GetBlock(0).Sightings.LastScan, 0);
}
