// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which weak planes of a fused map are replaced by planes of fewer triangles.
 */
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Returns/lms3dRegrouping.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace
{
constexpr double Bound = 0.01;
constexpr int BeamsOfFan = 100;
constexpr int TurnsOfScan = 50;
// Metres: so far from the plane of a group, a return is not on it, but a plane explains it.
constexpr double Beside = 0.94 * Bound;

/// A return seen from above. Beams are 1 cm from one another.
lms3dMappedReturn MakeReturn(int turn, int beam, double height)
{
  lms3dMappedReturn mapped;
  mapped.Point = { 0.01 * beam + 0.001, 0.01 * turn + 0.001, height };
  mapped.Direction = { 0.0, 0.0, -1.0 };
  mapped.Range = 2.0;
  mapped.BeamId = turn * BeamsOfFan + beam;
  mapped.Triangle = 0;
  mapped.Scan = 0;
  return mapped;
}

/// Tables of scans with different numbers of beams. The first one does a full turn.
lms3dTablesOfScans MakeTables()
{
  const double alpha[2] = { -45.0, 45.0 };
  const double circle[2] = { 0.0, 360.0 };
  const double part[2] = { 0.0, 90.0 };
  return { std::make_shared<lms3dBeamTable>(
             lms3dScanGeometry(alpha, BeamsOfFan, circle, TurnsOfScan)),
    std::make_shared<lms3dBeamTable>(lms3dScanGeometry(alpha, 7, part, TurnsOfScan)) };
}

/// Gives triangles to a plane. They are far from all returns.
void SetTriangles(int number, std::size_t triangles, lms3dFusedPlanes& planes)
{
  planes[number].Tiles.resize(1);
  planes[number].Tiles.front().Mesh.Points.resize(1);
  planes[number].Tiles.front().Mesh.Triangles.resize(triangles);
}

void Add(int number, const lms3dMappedReturn& mapped, lms3dFusedPlanes& planes)
{
  planes.GrowBox(number, mapped.Point);
  EXPECT_TRUE(planes.AddReturn(number, mapped));
}

/// Adds a horizontal plane of few returns.
int AddWeakPlane(
  double height, int turns, int beams, std::size_t triangles, lms3dFusedPlanes& planes)
{
  const int number = planes.MakePlane({ 0.0, 0.0, height }, { 0.0, 0.0, 1.0 });
  planes[number].IsWeak = true;
  SetTriangles(number, triangles, planes);
  for (int turn = 0; turn < turns; ++turn)
  {
    for (int beam = 0; beam < beams; ++beam)
    {
      Add(number, MakeReturn(turn, beam, height), planes);
    }
  }
  return number;
}

/// Lets triangles of a plane cover the cell of a return.
void Cover(int number, const lms3dMappedReturn& mapped, lms3dFusedPlanes& planes)
{
  const lms3dPoint2 place = planes[number].Frame.ToCells(mapped.Point);
  planes[number].Raster.Set(&lms3dRasterBlock::Covered,
    lms3dMakeCellStrip(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1])), true);
}

std::size_t CountReturns(const lms3dFusedPlanes& planes)
{
  std::size_t count = 0;
  for (const lms3dFusedPlane& plane : planes.GetAll())
  {
    count += plane.Returns.size();
  }
  return count;
}
} // namespace

/// Each of two planes has too many returns to be looked at with the other one. Both go, and only
/// the second one has triangles at two returns of the first one.
TEST(LMS3DRegrouping, LosesNoReturnToAPlaneThatGoes)
{
  lms3dFusedPlanes planes(Bound);
  const int first = AddWeakPlane(1.0, 41, 50, 20, planes);
  const int second = AddWeakPlane(1.0 + Beside, 41, 50, 10, planes);
  for (const int beam : { 20, 30 })
  {
    const lms3dMappedReturn mapped = MakeReturn(20, beam, 1.0 + Beside);
    Add(first, mapped, planes);
    Cover(second, mapped, planes);
  }
  const std::size_t before = CountReturns(planes);
  const lms3dTablesOfScans tables = MakeTables();
  lms3dRegrouping regrouping(planes, tables);
  regrouping.MakePlanes();
  ASSERT_EQ(planes.GetSize(), 4U);
  regrouping.Choose();
  EXPECT_TRUE(planes[first].HasGone);
  EXPECT_TRUE(planes[second].HasGone);
  EXPECT_EQ(CountReturns(planes), before);
  ASSERT_EQ(planes.GetSize(), 6U);
  EXPECT_EQ(planes[4].Verbatim.size(), 1U);
  EXPECT_EQ(planes[5].Verbatim.size(), 1U);
}

/// Two planes become one if they have at most 1,000 returns together. Otherwise each is looked at
/// for its own sake.
TEST(LMS3DRegrouping, JoinsPlanesOfFewReturns)
{
  for (const auto& [beams, made] : { std::pair<int, std::size_t>{ 25, 1 }, { 26, 2 } })
  {
    SCOPED_TRACE(beams);
    lms3dFusedPlanes planes(Bound);
    AddWeakPlane(1.0, 20, beams, 10, planes);
    AddWeakPlane(1.0, 20, beams, 10, planes);
    const lms3dTablesOfScans tables = MakeTables();
    lms3dRegrouping regrouping(planes, tables);
    EXPECT_TRUE(regrouping.MakePlanes());
    EXPECT_EQ(planes.GetSize(), 2 + made);
  }
}

/// Two planes are in one place, two bounds from one another. The new plane has fewer triangles for
/// one of them, and more for the other one.
TEST(LMS3DRegrouping, ReplacesEachPlaneOnItsOwn)
{
  lms3dFusedPlanes planes(Bound);
  const int first = AddWeakPlane(1.0, 20, 20, 20, planes);
  const int second = AddWeakPlane(1.0 + 2.0 * Bound, 20, 20, 5, planes);
  const lms3dTablesOfScans tables = MakeTables();
  lms3dRegrouping regrouping(planes, tables);
  ASSERT_TRUE(regrouping.MakePlanes());
  ASSERT_EQ(planes.GetSize(), 4U);
  SetTriangles(2, 2, planes);
  SetTriangles(3, 30, planes);
  regrouping.Choose();
  EXPECT_TRUE(planes[first].HasGone);
  EXPECT_FALSE(planes[2].HasGone);
  EXPECT_FALSE(planes[second].HasGone);
  EXPECT_TRUE(planes[3].HasGone);
}

/// Planes of two triangles are looked at, since several of them may become one. A single triangle
/// is not worth it.
TEST(LMS3DRegrouping, LooksAtPlanesOfTwoTriangles)
{
  for (const std::size_t triangles : { std::size_t{ 1 }, std::size_t{ 2 } })
  {
    SCOPED_TRACE(triangles);
    lms3dFusedPlanes planes(Bound);
    for (int i = 0; i < 4; ++i)
    {
      AddWeakPlane(1.0, 5, 5, triangles, planes);
    }
    const lms3dTablesOfScans tables = MakeTables();
    lms3dRegrouping regrouping(planes, tables);
    EXPECT_EQ(regrouping.MakePlanes(), triangles == 2);
  }
}

/// A return that is on no plane counts as a triangle, since it gets a facet.
TEST(LMS3DRegrouping, ReplacesPlanesByFewerTriangles)
{
  struct Case
  {
    std::size_t Triangles;
    bool HasOther;
    bool IsReplaced;
  };
  for (const Case& each :
    { Case{ 4, false, true }, { 5, false, false }, { 3, true, true }, { 4, true, false } })
  {
    SCOPED_TRACE(each.Triangles);
    lms3dFusedPlanes planes(Bound);
    const int number = AddWeakPlane(1.0, 5, 5, 5, planes);
    if (each.HasOther)
    {
      Add(number, MakeReturn(2, 2, 1.0 + Beside), planes);
    }
    const std::size_t before = CountReturns(planes);
    const lms3dTablesOfScans tables = MakeTables();
    lms3dRegrouping regrouping(planes, tables);
    regrouping.MakePlanes();
    ASSERT_EQ(planes.GetSize(), 2U);
    SetTriangles(1, each.Triangles, planes);
    regrouping.Choose();
    EXPECT_EQ(planes[number].HasGone, each.IsReplaced);
    EXPECT_NE(planes[1].HasGone, each.IsReplaced);
    EXPECT_EQ(CountReturns(planes), before);
    EXPECT_EQ(planes.GetSize(), each.IsReplaced && each.HasOther ? 3U : 2U);
  }
}

/// The place of two planes fails again and again. Each of them begins it once, unless it gets more
/// triangles.
TEST(LMS3DRegrouping, LooksAtEachPlaneForItsOwnSake)
{
  lms3dFusedPlanes planes(Bound);
  AddWeakPlane(1.0, 20, 20, 11, planes);
  const int second = AddWeakPlane(1.0, 20, 20, 10, planes);
  const lms3dTablesOfScans tables = MakeTables();
  const auto fail = [&]
  {
    lms3dRegrouping regrouping(planes, tables);
    const std::size_t before = planes.GetSize();
    const bool isTried = regrouping.MakePlanes();
    for (std::size_t i = before; i < planes.GetSize(); ++i)
    {
      SetTriangles(static_cast<int>(i), 50, planes);
    }
    regrouping.Choose();
    return isTried;
  };
  EXPECT_TRUE(fail());
  EXPECT_TRUE(fail());
  EXPECT_FALSE(fail());
  SetTriangles(second, 12, planes);
  EXPECT_TRUE(fail());
}
