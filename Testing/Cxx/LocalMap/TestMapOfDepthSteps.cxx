// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Counts rare faults of maps over many scans with fixed seeds: closed rooms whose maps are open,
 * and true depth steps that a map bridges.
 */
#include "Fixtures/SceneBuilder.h"
#include "LocalMap/MapFixtures.h"
#include "LocalMap/TrueSteps.h"

#include <vtkMath.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
#ifdef LMS3D_FEWER_BEAMS
constexpr int NumberOfRooms = 10;
#else
constexpr int NumberOfRooms = 100;
#endif

/// An empty room of any size, from any pose, at any resolution.
MapScene MakeEmptyRoom(int seed)
{
  Random random(static_cast<std::uint64_t>(seed));
  const Vector half = { random.Get(0.5, 6.0), random.Get(0.5, 6.0), random.Get(0.5, 6.0) };
  SceneBuilder room;
  room.AddBox(-1.0 * half, half);
  MapScene scene = { room.GetSurface() };
  for (int axis = 0; axis < 3; ++axis)
  {
    scene.Position[axis] = random.Get(-0.95, 0.95) * half[axis];
    scene.Orientation[axis] = random.Get(-180.0, 180.0);
  }
  scene.AlphaResolution = static_cast<int>(random.Get(7.0, 62.0));
  scene.BetaResolution = static_cast<int>(random.Get(8.0, 61.0));
  return scene;
}

/// The number of rooms whose map has an edge at which the surface ends.
int CountOpenRooms(double sigma, double bound)
{
  int open = 0;
  for (int seed = 0; seed < NumberOfRooms; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    vtkSmartPointer<vtkPolyData> scan = AddNoise(MakeScan(MakeEmptyRoom(seed)), sigma, random);
    MapPromise promise;
    promise.MaximumError = bound;
    promise.Noise = 4.0 * sigma;
    open += JudgeMap(scan, MakeMap(scan, bound), promise).NumberOfBoundaryEdges > 0;
  }
  return open;
}

/// The area of the triangles whose corners are at a height, metres.
double GetAreaAt(double height, vtkPolyData* map)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < map->GetNumberOfCells(); ++i)
  {
    double corners[3][3];
    bool isAt = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      map->GetPoint(map->GetCell(i)->GetPointId(corner), corners[corner]);
      isAt = isAt && std::abs(corners[corner][2] - height) < 0.001;
    }
    area += isAt ? vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]) : 0.0;
  }
  return area;
}

#ifndef LMS3D_FEWER_BEAMS
constexpr double DepthStep = 0.1;
// The share of the range that the filter adds between turns, which are 2 degrees apart: the angle
// in radians. Along fans, whose beams are 1 degree apart, it adds 2 %, so this share is wider
// there.
constexpr double ShareOfRange = 0.035;

/// The room from places spread over it.
MapScene MakeRoomFrom(int place)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
  Random random(static_cast<std::uint64_t>(place));
  if (place > 0)
  {
    scene.Position = { random.Get(-2.0, 3.0), random.Get(-2.0, 2.0), random.Get(0.6, 2.0) };
  }
  scene.AlphaResolution = 181;
  scene.BetaResolution = 180;
  return scene;
}
#endif
} // namespace

TEST(MapOfEmptyRooms, IsClosedInSpiteOfNoise)
{
  for (double sigma : { 0.0, 0.0025, 0.01, 0.02 })
  {
    EXPECT_EQ(CountOpenRooms(sigma, 4.0 * sigma), 0) << sigma;
  }
}

// Each fan has three returns on the top of the table, 0.4 and 0.6 m apart.
TEST(MapOfGrazedSurfaces, ShowsTheTopOfATable)
{
  constexpr double Height = -0.1;
  SceneBuilder room;
  room.AddBox({ -4.0, -4.0, -1.0 }, { 4.0, 4.0, 1.5 });
  room.AddBox({ 1.8, -0.8, -1.0 }, { 3.1, 0.8, Height });
  MapScene scene = { room.GetSurface() };
  scene.Position = { 0.0, 0.0, 0.0 };
  scene.AlphaResolution = 361;
  scene.BetaResolution = 360;
  // From the first return on the top to the last one.
  const double depth = -Height *
    (1.0 / std::tan(vtkMath::RadiansFromDegrees(2.0)) -
      1.0 / std::tan(vtkMath::RadiansFromDegrees(3.0)));
  EXPECT_GT(GetAreaAt(Height, MakeMap(MakeScan(scene), 0.01)), 0.9 * 1.6 * depth);
}

// Rounding makes no step, even if the depth step is 0.
TEST(MapOfDepthSteps, KeepsAWallWholeWithoutADepthStep)
{
  const std::vector<double> angles = MakeAngles(-20.0, 20.0, 41);
  const auto getRange = [&](int turn, int number)
  {
    return 3.0 / std::cos(vtkMath::RadiansFromDegrees(angles[turn])) /
      std::cos(vtkMath::RadiansFromDegrees(angles[number]));
  };
  vtkSmartPointer<vtkPolyData> wall = MakeScan(angles, angles, getRange);
  EXPECT_EQ(MakeMap(wall, 0.0, 0, 0.0)->GetNumberOfCells(), 2 * 40 * 40);
  EXPECT_LE(MakeMap(wall, 0.01, 0, 0.0)->GetNumberOfCells(), 4);
}

#ifndef LMS3D_FEWER_BEAMS
// In the default scan, steps of little more than twice the depth step count as well.
TEST(MapOfDepthSteps, BridgesNoTrueStepOfTheRoom)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
  scene.AlphaResolution = 361;
  scene.BetaResolution = 360;
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  const TrueSteps truth(scan, scene.Surface, DepthStep, 0.0);
  EXPECT_GT(truth.GetSteps().size(), 1500U);
  EXPECT_EQ(truth.CountBridged(MakeMap(scan, 0.01)), 0);
  int bridged = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    Random random(seed);
    bridged += truth.CountBridged(MakeMap(AddNoise(scan, 0.005, random), 0.02));
  }
  // All four scans have more than six thousand steps.
  EXPECT_LE(bridged, 5);
}

// From places all over the room.
TEST(MapOfDepthSteps, BridgesHardlyAnyLargeStep)
{
  std::size_t steps = 0;
  int bridged = 0;
  int bridgedWithNoise = 0;
  int bridgedWithMuchNoise = 0;
  for (int place = 0; place < 12; ++place)
  {
    const MapScene scene = MakeRoomFrom(place);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    const TrueSteps truth(scan, scene.Surface, DepthStep, ShareOfRange);
    steps += truth.GetSteps().size();
    bridged += truth.CountBridged(MakeMap(scan, 0.01));
    Random random(static_cast<std::uint64_t>(place));
    bridgedWithNoise += truth.CountBridged(MakeMap(AddNoise(scan, 0.005, random), 0.02));
    bridgedWithMuchNoise += truth.CountBridged(MakeMap(AddNoise(scan, 0.02, random), 0.08));
  }
  EXPECT_GT(steps, 5000U);
  EXPECT_EQ(bridged, 0);
  EXPECT_EQ(bridgedWithNoise, 0);
  EXPECT_EQ(bridgedWithMuchNoise, 0);
}
#endif
