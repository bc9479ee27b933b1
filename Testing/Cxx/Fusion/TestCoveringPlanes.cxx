// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the search for planes that cover returns with a look at all planes.
 */
#include "Fusion/Planes/lms3dCoveringPlanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
constexpr double Bound = 0.01;
constexpr int Count = 40;

lms3dMappedReturn MakeReturn(const lms3dVector& point)
{
  lms3dMappedReturn mapped;
  mapped.Point = point;
  mapped.Direction = { 0.0, 0.0, -1.0 };
  mapped.Range = 2.0;
  mapped.BeamId = 0;
  mapped.Triangle = 0;
  mapped.Scan = 0;
  return mapped;
}

/// Horizontal planes within the bound of one another. Each covers the cells around a few places.
class Planes
{
public:
  Planes()
  {
    for (int i = 0; i < Count; ++i)
    {
      const int number =
        this->All.MakePlane({ 0.0, 0.0, 0.5 * Bound * this->Get(0.0, 1.0) }, { 0.0, 0.0, 1.0 });
      for (int j = 0; j < 5; ++j)
      {
        this->Cover(number, { this->Get(0.0, 0.3), this->Get(0.0, 0.3), 0.0 });
      }
    }
  }

  double Get(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  /// The first plane that covers a return and that its vertical beam meets. If there is none, the
  /// first one that covers it.
  int FindAmongAll(const lms3dMappedReturn& mapped, int exception, double distance) const
  {
    int beside = -1;
    for (int number = 0; number < Count; ++number)
    {
      const lms3dFusedPlane& plane = this->All[number];
      if (number == exception || std::abs(plane.Frame.GetHeight(mapped.Point)) > distance ||
        !this->All.Covers(plane, mapped))
      {
        continue;
      }
      const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
      if (plane.Raster.Has(
            &lms3dRasterBlock::Covered, lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])))
      {
        return number;
      }
      beside = beside < 0 ? number : beside;
    }
    return beside;
  }

  lms3dFusedPlanes All{ Bound };

private:
  void Cover(int number, const lms3dVector& point)
  {
    lms3dFusedPlane& plane = this->All[number];
    const lms3dPoint2 place = plane.Frame.ToCells(point);
    const std::int32_t u = lms3dGetCellOf(place[0]);
    const std::int32_t v = lms3dGetCellOf(place[1]);
    for (std::int32_t row = v - 9; row <= v + 9; ++row)
    {
      plane.Raster.SetRow(&lms3dRasterBlock::Covered, row, u - 9, u + 9, true, true, [](int) {});
      for (const std::int32_t cell : { u - 9, u + 10 })
      {
        this->All.GrowBox(number, plane.Frame.ToWorld({ 1.0 * cell, row + 0.5 }));
      }
    }
  }

  std::mt19937 Random{ 5 };
};
} // namespace

/// Returns follow one another side by side, and jump now and then.
TEST(LMS3DCoveringPlanes, AreTheFirstOfAll)
{
  Planes planes;
  lms3dCoveringPlanes search(planes.All);
  lms3dVector point = { 0.1, 0.1, 0.0 };
  int covered = 0;
  for (int i = 0; i < 3000; ++i)
  {
    if (i % 17 == 0)
    {
      point = { planes.Get(0.0, 0.3), planes.Get(0.0, 0.3), 0.0 };
    }
    point[0] += planes.Get(-0.01, 0.012);
    point[2] = planes.Get(-0.5 * Bound, Bound);
    const lms3dMappedReturn mapped = MakeReturn(point);
    const int exception = i % Count;
    const double distance = planes.Get(0.0, Bound);
    const int expected = planes.FindAmongAll(mapped, exception, distance);
    ASSERT_EQ(search.Find(mapped, { exception }, distance), expected) << i;
    covered += expected >= 0 ? 1 : 0;
  }
  EXPECT_GT(covered, 300);
  EXPECT_LT(covered, 2700);
}

/// What was found before is not found after it has been cleared.
TEST(LMS3DCoveringPlanes, AreNotThoseThatWent)
{
  Planes planes;
  lms3dCoveringPlanes search(planes.All);
  for (int i = 0; i < 300; ++i)
  {
    const lms3dMappedReturn mapped =
      MakeReturn({ planes.Get(0.0, 0.3), planes.Get(0.0, 0.3), 0.5 * Bound });
    const int found = search.Find(mapped, {}, Bound);
    if (found >= 0)
    {
      planes.All.Clear(found);
      EXPECT_NE(search.Find(mapped, {}, Bound), found);
    }
  }
  EXPECT_LT(std::count_if(planes.All.GetAll().begin(), planes.All.GetAll().end(),
              [](const lms3dFusedPlane& plane) { return !plane.HasGone; }),
    Count);
}

namespace
{
/// Covers one cell of a plane, with the cells beside it in its box.
void CoverCell(int number, std::int32_t u, std::int32_t v, lms3dFusedPlanes& planes)
{
  lms3dFusedPlane& plane = planes[number];
  plane.Raster.Make(0, 0);
  plane.Raster.Set(&lms3dRasterBlock::Covered, lms3dMakeCellStrip(u, v), true);
  planes.GrowBox(number, plane.Frame.ToWorld({ u - 2.0, v - 2.0 }));
  planes.GrowBox(number, plane.Frame.ToWorld({ u + 3.0, v + 3.0 }));
}
} // namespace

/// The second plane is met, the first and the third one only cover the return beside it.
TEST(LMS3DCoveringPlanes, AreMetByTheBeamIfPossible)
{
  lms3dFusedPlanes planes(Bound);
  for (int number = 0; number < 3; ++number)
  {
    planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    CoverCell(number, number == 1 ? 20 : 21, 20, planes);
  }
  const lms3dMappedReturn mapped = MakeReturn(planes[0].Frame.ToWorld({ 20.5, 20.5 }));
  EXPECT_EQ(lms3dCoveringPlanes(planes).Find(mapped, {}, Bound), 1);
  EXPECT_EQ(lms3dCoveringPlanes(planes).Find(mapped, { 1 }, Bound), 0);
  planes[0].Verbatim.resize(1);
  EXPECT_EQ(lms3dCoveringPlanes(planes).Find(mapped, { 1 }, Bound), 2);
  planes[2].Verbatim.resize(1);
  EXPECT_EQ(lms3dCoveringPlanes(planes).Find(mapped, { 1 }, Bound), -1);
  planes[1].Verbatim.resize(1);
  EXPECT_EQ(lms3dCoveringPlanes(planes).Find(mapped, {}, Bound), 1);
}

/// The return lies half a bound above the plane, and its beam goes on by two cells.
TEST(LMS3DFusedPlanes, AreMetWhereTheBeamEndsInThePlane)
{
  lms3dFusedPlanes planes(Bound);
  planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  const lms3dPlaneFrame& frame = planes[0].Frame;
  const lms3dVector foot = frame.ToWorld({ 20.5, 20.5 });
  const lms3dVector ahead = lms3dSubtract(frame.ToWorld({ 22.5, 20.5 }), foot);
  const lms3dVector height = { 0.0, 0.0, 0.5 * Bound };
  lms3dMappedReturn mapped = MakeReturn(lms3dAdd(foot, height));
  mapped.Direction = lms3dNormalize(lms3dSubtract(ahead, height));
  CoverCell(0, 20, 20, planes);
  EXPECT_FALSE(planes.IsMetBy(planes[0], mapped));
  CoverCell(0, 22, 20, planes);
  EXPECT_TRUE(planes.IsMetBy(planes[0], mapped));
  mapped.Point = lms3dAdd(foot, lms3dSubtract(lms3dScale(ahead, 2.0), height));
  EXPECT_TRUE(planes.IsMetBy(planes[0], mapped)) << "the return lies behind the plane";
  mapped.Point = lms3dAdd(foot, lms3dScale(height, 3.0));
  EXPECT_FALSE(planes.IsMetBy(planes[0], mapped)) << "the plane is too far behind";
  mapped.Direction = { 1.0, 0.0, 0.0 };
  EXPECT_FALSE(planes.IsMetBy(planes[0], mapped)) << "the beam is parallel";
}

/// The first cell of the next tile is 1024. Its mesh is not made anew when the triangles before go.
TEST(LMS3DFusedPlanes, CoverReturnsOfTheirOwnTileAlone)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    lms3dFusedPlanes planes(Bound);
    lms3dFusedPlane& plane = planes[planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 })];
    const auto at = [&](double along)
    {
      const lms3dPoint2 place = { axis == 0 ? along : 12.5, axis == 0 ? 12.5 : along };
      return MakeReturn(plane.Frame.ToWorld(place));
    };
    const auto isStaleAfter = [&](double along)
    {
      plane.Raster.ClearMarks();
      EXPECT_TRUE(planes.AddReturn(0, at(along)));
      return plane.Raster.HasMark(along > 1024.0 ? 1 : 0, lms3dRaster::STALE);
    };
    plane.Raster.Make(axis == 0 ? 15 : 0, axis == 0 ? 0 : 15);
    plane.Raster.Make(axis == 0 ? 16 : 0, axis == 0 ? 0 : 16);
    plane.Raster.Set(&lms3dRasterBlock::Covered,
      axis == 0 ? lms3dMakeCellStrip(1023, 12) : lms3dMakeCellStrip(12, 1023), true);
    for (const double beyond : { 1024.5, 1025.5 })
    {
      EXPECT_TRUE(planes.Covers(plane, at(2047.0 - beyond)));
      EXPECT_FALSE(planes.Covers(plane, at(beyond)));
      EXPECT_FALSE(isStaleAfter(2047.0 - beyond));
      EXPECT_TRUE(isStaleAfter(beyond));
    }
    plane.Verbatim.resize(1);
    EXPECT_TRUE(planes.Covers(plane, at(1025.5))) << "the plane has one tile";
  }
}
