// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the planes that are made of returns of several scans.
 */
#include "Fusion/Returns/lms3dRegroupedPlane.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <vector>

namespace
{
constexpr double Bound = 0.01;
constexpr int Turns = 6;

/// A return on the plane z = 1, seen from above.
lms3dMappedReturn MakeReturn(int scan, int beamId, double x, double y)
{
  lms3dMappedReturn mapped;
  mapped.Point = { x, y, 1.0 };
  mapped.Direction = { 0.0, 0.0, -1.0 };
  mapped.Range = 2.0;
  mapped.BeamId = beamId;
  mapped.Triangle = 0;
  mapped.Scan = scan;
  return mapped;
}

std::shared_ptr<const lms3dBeamTable> MakeTable(int beams, double extent)
{
  const double alpha[2] = { -45.0, 45.0 };
  const double beta[2] = { 0.0, extent };
  return std::make_shared<lms3dBeamTable>(lms3dScanGeometry(alpha, beams, beta, Turns));
}

/// Makes a plane of all returns.
int MakePlane(const std::vector<lms3dMappedReturn>& returns, const std::vector<int>& oldPlanes,
  const lms3dTablesOfScans& tables, lms3dFusedPlanes& planes)
{
  lms3dReturnGroup group = { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, 0.0, {} };
  group.Returns.resize(returns.size());
  std::iota(group.Returns.begin(), group.Returns.end(), 0);
  const int number = lms3dMakeRegroupedPlane(group, oldPlanes, planes);
  const lms3dWorldBox box =
    lms3dFillRegroupedPlane(number, returns, group, oldPlanes, tables, planes);
  planes.GrowBox(number, box.Low);
  planes.GrowBox(number, box.High);
  return number;
}

/// Whether a plane has surface half way between two returns.
bool HasSurfaceBetween(
  const lms3dMappedReturn& a, const lms3dMappedReturn& b, const lms3dFusedPlane& plane)
{
  const lms3dPoint2 place = plane.Frame.ToCells(lms3dScale(lms3dAdd(a.Point, b.Point), 0.5));
  return plane.Raster.Has(
    &lms3dRasterBlock::May, lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]));
}

/// Whether a plane of two returns of scan 1 has surface between them.
bool AreJoined(int firstBeam, int secondBeam, const lms3dTablesOfScans& tables)
{
  const std::vector<lms3dMappedReturn> returns = { MakeReturn(1, firstBeam, 0.0, 0.0),
    MakeReturn(1, secondBeam, 0.05, 0.0) };
  lms3dFusedPlanes planes(Bound);
  return HasSurfaceBetween(returns[0], returns[1], planes[MakePlane(returns, {}, tables, planes)]);
}
} // namespace

/// Fans of scan 1 have 10 beams.
TEST(LMS3DRegroupedPlane, HasSurfaceBetweenNeighboursOfTheirScan)
{
  const lms3dTablesOfScans open = { nullptr, MakeTable(10, 90.0), MakeTable(4, 360.0) };
  EXPECT_TRUE(AreJoined(23, 24, open));
  EXPECT_TRUE(AreJoined(23, 33, open));
  EXPECT_TRUE(AreJoined(23, 34, open));
  EXPECT_FALSE(AreJoined(23, 27, open)) << "neighbours by the fans of another scan";
  EXPECT_FALSE(AreJoined(29, 30, open)) << "the end of a fan, and the start of the next one";
  EXPECT_FALSE(AreJoined(3, 53, open)) << "the first and the last turn";
  const lms3dTablesOfScans closed = { nullptr, MakeTable(10, 360.0) };
  EXPECT_TRUE(AreJoined(53, 3, closed));
}

/// The returns of two old planes are not in the order of their scans.
TEST(LMS3DRegroupedPlane, CountsEachScanOnce)
{
  const lms3dTablesOfScans tables(8, MakeTable(10, 90.0));
  std::vector<lms3dMappedReturn> returns;
  for (const int scan : { 5, 6, 7, 1, 6, 2, 3 })
  {
    returns.push_back(MakeReturn(scan, 0, 0.01, 0.01));
  }
  lms3dFusedPlanes planes(Bound);
  const lms3dFusedPlane& plane = planes[MakePlane(returns, {}, tables, planes)];
  ASSERT_EQ(plane.Raster.GetNumberOfBlocks(), 1);
  EXPECT_EQ(plane.Raster.GetBlock(0).Sightings.ScanCount, 6);
  EXPECT_EQ(plane.Raster.GetBlock(0).Sightings.LastScan, 7);
  EXPECT_EQ(plane.Returns.size(), returns.size());
}

/// A triangle of an old plane goes far beyond the returns.
TEST(LMS3DRegroupedPlane, HasABoxAroundTheTrianglesOfOldPlanes)
{
  const lms3dTablesOfScans tables = { MakeTable(10, 90.0) };
  const std::array<lms3dVector, 3> corners = { { { 0.0, 0.0, 1.0 }, { 0.5, 0.0, 1.002 },
    { 0.0, -0.4, 0.998 } } };
  lms3dFusedPlanes planes(Bound);
  const int old = planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  planes[old].Tiles.emplace_back();
  lms3dFusedMesh& mesh = planes[old].Tiles.front().Mesh;
  mesh.Points.assign(corners.begin(), corners.end());
  mesh.Triangles.push_back({ 0, 1, 2 });
  const int number = MakePlane({ MakeReturn(0, 0, 0.001, 0.001) }, { old }, tables, planes);
  const lms3dWorldBox box = planes.GetBox(static_cast<std::size_t>(number));
  for (const lms3dVector& corner : corners)
  {
    EXPECT_TRUE(box.IsNear(corner, 0.0));
  }
  const lms3dMappedReturn far = MakeReturn(0, 1, 0.4, -0.01);
  EXPECT_TRUE(planes.Shows(planes[number], far));
  EXPECT_EQ(planes.FindPlanesNear({ far }, planes.GetSize()), std::vector<int>{ number });
}

/// Other sides of tiles would make the triangles of a plane others, far away from the returns, too.
TEST(LMS3DRegroupedPlane, HasTheTilesOfAnOldPlaneThatIsNearlyTheSame)
{
  const lms3dTablesOfScans tables = { MakeTable(10, 90.0) };
  const lms3dVector far = { 5.0, 7.0, 1.001 };
  lms3dFusedPlanes planes(Bound);
  const int above = planes.MakePlane(far, { 0.0, 0.0, 1.0 });
  const int across = planes.MakePlane({ 5.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 });
  const auto getPlace = [&](const std::vector<int>& oldPlanes)
  { return planes[MakePlane({}, oldPlanes, tables, planes)].Frame.ToCells(far); };
  const lms3dPoint2 same = planes[above].Frame.ToCells(far);
  EXPECT_NEAR(getPlace({ across, above })[0], same[0], 1e-9);
  EXPECT_NEAR(getPlace({ across, above })[1], same[1], 1e-9);
  EXPECT_GT(std::abs(getPlace({ across })[0] - same[0]), 1000.0);
}
