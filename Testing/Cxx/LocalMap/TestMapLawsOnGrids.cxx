// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the laws of the local map on scans of various resolutions and ranges of angles, and on
 * synthetic ranges.
 */
#include "LocalMap/MapFixtures.h"

#include "Fixtures/SceneFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

namespace
{
constexpr std::uint64_t Seed = 20090402;

const double Bounds[] = { 0.0, 0.001, 0.01, 0.05, 1.0 };

struct Angles
{
  const char* Name;
  std::array<double, 2> AlphaRange;
  std::array<double, 2> BetaRange;
  int AlphaResolution;
  int BetaResolution;
};

std::ostream& operator<<(std::ostream& os, const Angles& angles)
{
  return os << angles.Name;
}

const Angles Grids[] = {
  { "TwoByTwo", { -20.0, 20.0 }, { -10.0, 10.0 }, 2, 2 },
  { "TwoByTwoPoles", { -90.0, 90.0 }, { 0.0, 360.0 }, 2, 2 },
  { "ThreeByThree", { -90.0, 90.0 }, { 0.0, 360.0 }, 3, 3 },
  { "OneBeam", { 10.0, 10.5 }, { 30.0, 31.0 }, 1, 1 },
  { "OneTurn", { -90.0, 90.0 }, { 20.0, 380.0 }, 91, 1 },
  { "TwoTurns", { -90.0, 90.0 }, { 0.0, 360.0 }, 91, 2 },
  { "OneRow", { -5.0, 90.0 }, { 0.0, 360.0 }, 1, 90 },
  { "OnePole", { -90.0, 90.0 }, { 0.0, 360.0 }, 1, 12 },
  { "TenDegrees", { -90.0, 90.0 }, { 0.0, 360.0 }, 19, 36 },
  { "QuarterSphere", { 0.0, 90.0 }, { -90.0, 90.0 }, 10, 19 },
  { "NoPoles", { -89.0, 89.0 }, { 0.0, 360.0 }, 90, 90 },
  { "HalfTurn", { -90.0, 90.0 }, { -180.0, 0.0 }, 61, 61 },
  { "AlmostFullTurn", { -40.0, 40.0 }, { 0.0, 356.0 }, 41, 90 },
  { "FullTurnElsewhere", { -90.0, 90.0 }, { -123.0, 237.0 }, 61, 60 },
  { "HalfDegree", { -20.0, 20.0 }, { -20.0, 20.0 }, 81, 81 },
  { "NarrowFan", { -90.0, 90.0 }, { 0.0, 360.0 }, 361, 12 },
};

class MapLawsOnGrids : public testing::TestWithParam<Angles>
{
protected:
  MapScene Look(const std::string& name) const
  {
    MapScene scene = MakeMapScene(name);
    scene.AlphaRange = GetParam().AlphaRange;
    scene.BetaRange = GetParam().BetaRange;
    scene.AlphaResolution = GetParam().AlphaResolution;
    scene.BetaResolution = GetParam().BetaResolution;
    return scene;
  }
};
} // namespace

TEST_P(MapLawsOnGrids, HoldWithAndWithoutNoise)
{
  for (const char* name : { "ClosedRoom", "TurnedRoom", "Pole", "FurnishedRoom" })
  {
    const MapScene scene = this->Look(name);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    Random random(Seed);
    vtkSmartPointer<vtkPolyData> noisy = AddNoise(scan, 0.005, random);
    for (double bound : Bounds)
    {
      SCOPED_TRACE(std::string(name) + " within " + std::to_string(bound));
      ExpectLawful(scan, { bound, 0.1, scene.Surface });
      ExpectLawful(noisy, { bound, 0.1, scene.Surface, 0.02 });
    }
  }
}

// If the turns or the beams come in reverse order, the map may differ, but the laws hold.
TEST_P(MapLawsOnGrids, HoldForTheOtherWayRound)
{
  const MapScene scene = this->Look("ClosedRoom");
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  for (double bound : Bounds)
  {
    SCOPED_TRACE(bound);
    const MapVerdict there = ExpectLawful(scan, { bound, 0.1, scene.Surface });
    for (const auto& reversed :
      { ReverseTurns(scan), ReverseFan(scan), ReverseFan(ReverseTurns(scan)) })
    {
      const MapVerdict back = ExpectLawful(reversed, { bound, 0.1, scene.Surface });
      EXPECT_EQ(back.NumberOfBoundaryEdges > 0, there.NumberOfBoundaryEdges > 0);
      EXPECT_EQ(back.EulerCharacteristic, there.EulerCharacteristic);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, MapLawsOnGrids, testing::ValuesIn(Grids),
  [](const auto& grid) { return grid.param.Name; });

namespace
{
/// Judges a scan without a scene for all bounds.
void ExpectLawfulForAllBounds(vtkPolyData* scan)
{
  for (double bound : Bounds)
  {
    SCOPED_TRACE(bound);
    ExpectLawful(scan, { bound, 0.1 });
  }
}

std::vector<double> MakeTurns(int count)
{
  return MakeAngles(0.0, 360.0 - 360.0 / count, count);
}
} // namespace

TEST(MapLawsOnRanges, HoldForACheckerboard)
{
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60),
    [](int turn, int number) { return (turn + number) % 2 == 0 ? 4.0 : 5.0; }));
}

TEST(MapLawsOnRanges, HoldForPureNoise)
{
  Random random(Seed);
  ExpectLawfulForAllBounds(MakeScan(
    MakeAngles(-90.0, 90.0, 61), MakeTurns(60), [&](int, int) { return random.Get(1.0, 10.0); }));
}

TEST(MapLawsOnRanges, HoldForASingleReturn)
{
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60),
    [](int turn, int number) { return turn == 17 && number == 23 ? 3.0 : 0.0; }));
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60),
    [](int turn, int number) { return turn == 17 && number == 60 ? 3.0 : 0.0; }));
}

TEST(MapLawsOnRanges, HoldForNoReturn)
{
  ExpectLawfulForAllBounds(
    MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60), [](int, int) { return 0.0; }));
}

TEST(MapLawsOnRanges, HoldForEverySecondReturn)
{
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60),
    [](int turn, int number) { return (turn + number) % 2 == 0 ? 4.0 : 0.0; }));
}

TEST(MapLawsOnRanges, HoldForMissesAmongReturns)
{
  Random random(Seed);
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 91), MakeTurns(90),
    [&](int, int) { return random.Get() < 0.2 ? 0.0 : 4.0; }));
}

// At a pole, ranges differ from turn to turn, as noise or a moving sensor makes them.
TEST(MapLawsOnRanges, HoldWhereTurnsDisagreeAtThePole)
{
  Random random(Seed);
  ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 61), MakeTurns(60),
    [&](int, int number) { return number == 60 ? random.Get(3.9, 4.1) : 4.0; }));
}

TEST(MapLawsOnRanges, HoldForThingsFarSmallAndLarge)
{
  for (double size : { 1e-4, 1e6 })
  {
    SCOPED_TRACE(size);
    ExpectLawfulForAllBounds(MakeScan(MakeAngles(-90.0, 90.0, 37), MakeTurns(36),
      [&](int turn, int number) { return size * (4.0 + 0.1 * std::sin(turn + 0.3 * number)); }));
  }
}

namespace
{
// A hatch of 30 by 45 degrees in a ball of 5 m.
vtkSmartPointer<vtkPolyData> ScanBallWithHatch(double depth)
{
  return MakeScan(MakeAngles(-90.0, 90.0, 121), MakeTurns(120),
    [&](int turn, int number)
    {
      const bool isHatch = turn >= 40 && turn < 55 && number >= 55 && number < 75;
      return isHatch ? 5.0 + depth : 5.0;
    });
}
} // namespace

TEST(MapLawsOnRanges, HoldAtDepthStepsOfAnySize)
{
  for (double depth : { 0.005, 0.02, 0.5, -0.005, -0.02, -0.5 })
  {
    SCOPED_TRACE(depth);
    ExpectLawfulForAllBounds(ScanBallWithHatch(depth));
  }
}

TEST(MapLawsOnRanges, StayClosedAtSmallStepsOnly)
{
  for (double bound : Bounds)
  {
    SCOPED_TRACE(bound);
    for (double depth : { 0.005, 0.02 })
    {
      vtkSmartPointer<vtkPolyData> scan = ScanBallWithHatch(depth);
      ExpectClosed(JudgeMap(scan, MakeMap(scan, bound), { bound, 0.1 }));
    }
    // The hatch and its frame are two surfaces for any bound, with two rims.
    vtkSmartPointer<vtkPolyData> scan = ScanBallWithHatch(0.5);
    const MapVerdict verdict = JudgeMap(scan, MakeMap(scan, bound), { bound, 0.1 });
    EXPECT_GT(verdict.NumberOfBoundaryEdges, 0);
    EXPECT_EQ(verdict.EulerCharacteristic, 2) << "a disc, and a ball with a hole";
  }
}

// The returns of each pole span 0.6 m.
TEST(MapLawsOnRanges, HoldAtPolesWithAnyNoise)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(MakeAngles(-90.0, 90.0, 19), MakeTurns(36),
    [](int turn, int number)
    { return number % 18 == 0 ? 2.0 + 0.3 * std::sin(1.0 * turn * turn) : 2.0; });
  for (double bound : { 0.001, 0.01, 0.1, 0.25 })
  {
    SCOPED_TRACE(bound);
    EXPECT_LE(ExpectLawful(scan, { bound, 0.1 }).LargestDeviation, bound * (1.0 + 1e-9));
  }
}
