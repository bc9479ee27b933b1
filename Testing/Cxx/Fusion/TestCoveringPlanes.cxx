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

  /// The first plane that covers a return.
  int FindAmongAll(const lms3dMappedReturn& mapped, int exception, double distance) const
  {
    for (int number = 0; number < Count; ++number)
    {
      const lms3dFusedPlane& plane = this->All[number];
      if (number != exception && std::abs(plane.Frame.GetHeight(mapped.Point)) <= distance &&
        this->All.Covers(plane, mapped))
      {
        return number;
      }
    }
    return -1;
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
