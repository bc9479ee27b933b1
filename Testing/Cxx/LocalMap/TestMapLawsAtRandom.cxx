// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the laws of the local map on 200 random scenes, scans and bounds with fixed seeds.
 */
#include "LocalMap/MapFixtures.h"

#include "Fixtures/SceneBuilder.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace
{
double Pick(Random& random, const std::vector<double>& values)
{
  return values[static_cast<std::size_t>(random.Get() * static_cast<double>(values.size()))];
}

class MapLawsAtRandom : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(MapLawsAtRandom, Hold)
{
  Random random(static_cast<std::uint64_t>(GetParam()));
  const MapScene scene = MakeRandomMapScene(random);
  const double bound = Pick(random, { 0.0, 0.001, 0.01, 0.05, 0.2, 1.0 });
  const double sigma = Pick(random, { 0.0, 0.0, 0.002, 0.005 });
  const double misses = Pick(random, { 0.0, 0.0, 0.02, 0.3 });
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  if (sigma > 0.0)
  {
    scan = AddNoise(scan, sigma, random);
  }
  if (misses > 0.0)
  {
    scan = Keep(scan, [&](vtkIdType) { return random.Get() >= misses; });
  }
  SCOPED_TRACE("a bound of " + std::to_string(bound) + " m, noise of " + std::to_string(sigma) +
    " m, misses " + std::to_string(misses) + ", " + std::to_string(scene.AlphaResolution) + " x " +
    std::to_string(scene.BetaResolution) + " beams");
  ExpectLawful(scan, { bound, 0.1, scene.Surface, 4.0 * sigma });
}

// Noise moves vertices off their returns. In a coarse scan, rounding can let the beam of such a
// vertex miss all triangles. Its return counts as well.
TEST(MapsOfCoarseScans, TellTheLargestDeviation)
{
  for (std::uint64_t seed : { 479, 678, 879, 977 })
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const MapScene scene = MakeRandomMapScene(random);
    vtkSmartPointer<vtkPolyData> scan = AddNoise(MakeScan(scene), 0.01, random);
    ExpectLawful(scan, { 0.04, 0.1, scene.Surface, 0.04 });
  }
}

// For random resolutions and poses.
TEST(MapsOfEmptyRooms, AreClosed)
{
  Random random(20090404);
  for (int i = 0; i < 200; ++i)
  {
    SCOPED_TRACE(i);
    const Vector half = { random.Get(0.5, 6.0), random.Get(0.5, 6.0), random.Get(0.5, 6.0) };
    SceneBuilder room;
    room.AddBox(-1.0 * half, half);
    MapScene scene = { room.GetSurface() };
    for (int axis = 0; axis < 3; ++axis)
    {
      scene.Position[axis] = random.Get(-0.99, 0.99) * half[axis];
      scene.Orientation[axis] = random.Get(-180.0, 180.0);
    }
    scene.AlphaResolution = static_cast<int>(random.Get(7.0, 62.0));
    scene.BetaResolution = static_cast<int>(random.Get(8.0, 61.0));
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    ExpectClosed(ExpectLawful(scan, { 0.0, 0.1, scene.Surface }));
    ExpectClosed(ExpectLawful(scan, { 0.01, 0.1, scene.Surface }));
  }
}

#ifdef LMS3D_FEWER_BEAMS
constexpr int NumberOfScenes = 40;
#else
constexpr int NumberOfScenes = 200;
#endif
INSTANTIATE_TEST_SUITE_P(Seeds, MapLawsAtRandom, testing::Range(0, NumberOfScenes));
