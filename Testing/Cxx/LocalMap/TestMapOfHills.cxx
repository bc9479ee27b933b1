// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that maps of hills have few triangles, leave few slopes open and bridge hardly any step.
 */
#include "Fixtures/SceneBuilder.h"
#include "LocalMap/MapFixtures.h"
#include "LocalMap/TrueSteps.h"

#include <gtest/gtest.h>

#include <cmath>

#ifndef LMS3D_FEWER_BEAMS
namespace
{
constexpr double DepthStep = 0.1;
// The share of the range that the filter adds between turns, which are 2 degrees apart: the angle
// in radians. Along fans, whose beams are 1 degree apart, it adds 2 %, so this share is wider
// there.
constexpr double ShareOfRange = 0.035;

/// Waves of five lengths and directions.
double GetHeight(double x, double y)
{
  double height = 0.0;
  double length = 50.0;
  double amplitude = 4.0;
  for (int wave = 0; wave < 5; ++wave)
  {
    const double along = x * std::cos(2.0 * wave) + y * std::sin(2.0 * wave);
    const double across = y * std::cos(2.0 * wave) - x * std::sin(2.0 * wave);
    const double scale = 2.0 * std::acos(-1.0) / length;
    height += amplitude * std::sin(scale * along + wave) * std::cos(scale * across);
    length *= 0.45;
    amplitude *= 0.4;
  }
  return height;
}

/// Triangles of one metre. The sensor is two metres above the ground, at a place near the middle.
MapScene MakeHills(double x, double y)
{
  constexpr int Half = 60;
  SceneBuilder hills;
  const auto getPoint = [](double east, double north) {
    return Vector{ east, north, GetHeight(east, north) };
  };
  for (int east = -Half; east < Half; ++east)
  {
    for (int north = -Half; north < Half; ++north)
    {
      const Vector corner = getPoint(east, north);
      const Vector opposite = getPoint(east + 1, north + 1);
      hills.AddTriangle(corner, getPoint(east + 1, north), opposite);
      hills.AddTriangle(corner, opposite, getPoint(east, north + 1));
    }
  }
  MapScene scene = { hills.GetSurface() };
  scene.Position = { x, y, GetHeight(x, y) + 2.0 };
  scene.AlphaResolution = 181;
  scene.BetaResolution = 180;
  return scene;
}
} // namespace

// Patches of hills have few returns each.
TEST(MapOfHills, IsSmallerThanThePlainGridWithinMillimetres)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(MakeHills(0.0, 0.0));
  vtkIdType triangles = 6 * MakeMap(scan, 0.0)->GetNumberOfCells() / 10;
  for (double bound : { 0.001, 0.005, 0.01, 0.02 })
  {
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan, bound);
    EXPECT_LT(map->GetNumberOfCells(), triangles) << bound;
    triangles = map->GetNumberOfCells();
    ExpectLawful(scan, map, { bound });
  }
}

TEST(MapOfHills, JoinsGentleSlopesAndBridgesHardlyAnyStep)
{
  std::size_t steps = 0;
  std::size_t slopes = 0;
  int bridged = 0;
  int bridgedBeyondTolerance = 0;
  int open = 0;
  for (double place : { -17.3, -6.1, 4.4, 15.2 })
  {
    const MapScene scene = MakeHills(place, 0.7 * place);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    const TrueSteps truth(scan, scene.Surface, DepthStep, 0.0);
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.01);
    steps += truth.GetSteps().size();
    slopes += truth.GetSlopes().size();
    bridged += truth.CountBridged(map);
    bridgedBeyondTolerance +=
      TrueSteps(scan, scene.Surface, DepthStep, ShareOfRange).CountBridged(map);
    open += truth.CountOpen(map);
  }
  EXPECT_GT(steps, 2500U);
  EXPECT_GT(slopes, 20000U);
  EXPECT_EQ(bridgedBeyondTolerance, 0);
  // Steps of little more than twice the depth step count as well, at any range.
  EXPECT_LT(bridged, 0.0025 * static_cast<double>(steps));
  EXPECT_LT(open, 0.3333 * static_cast<double>(slopes));
}
#endif
