// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which returns count as speckles, and that the surface goes on behind them.
 */
#include "LocalMap/GapFixtures.h"

#include <vtkFieldData.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{
constexpr int Middle = WallScan::Middle;

vtkIdType CountTrianglesOfWall()
{
  return MakeMap(WallScan().Make(), GapProperties())->GetNumberOfCells();
}

double CountSpeckles(vtkPolyData* scan, int maximumSize)
{
  return GetField(MakeMap(scan, GapProperties{ 0, maximumSize }), "NumberOfSpeckles");
}
} // namespace

TEST(MapOfSpeckles, GoesOnBehindAStrayReturn)
{
  const GapBeam stray = { Middle - 3, Middle + 5 };
  for (double range : { 1.5, 4.5 })
  {
    vtkSmartPointer<vtkPolyData> scan = WallScan().Set(stray, range).Make();
    EXPECT_FALSE(MakeMap(scan, GapProperties())->GetFieldData()->HasArray("NumberOfSpeckles"));

    vtkSmartPointer<vtkPolyData> kept = MakeMap(scan, GapProperties{ 0, 1 });
    EXPECT_EQ(kept->GetNumberOfCells(), CountTrianglesOfWall() + 1);
    EXPECT_EQ(CountHits(kept, stray), 2);
    EXPECT_EQ(GetField(kept, "NumberOfSpeckles"), 1.0);
    EXPECT_EQ(GetField(kept, "NumberOfReturnsOnSpeckles"), 1.0);
    EXPECT_EQ(
      GetFieldValues(kept, "SpeckleBeamIds"), std::vector<int>{ WallScan::GetBeamId(stray) });
    EXPECT_FALSE(kept->GetFieldData()->HasArray("NumberOfClosedGaps"));
    EXPECT_EQ(CountReturnsOnAll(kept), static_cast<double>(scan->GetNumberOfPoints()));
    EXPECT_LE(GetLargestDistance(scan, kept), 0.01);

    vtkSmartPointer<vtkPolyData> leftOut = MakeMap(scan, GapProperties{ 0, 1, false });
    EXPECT_EQ(leftOut->GetNumberOfCells(), CountTrianglesOfWall());
    EXPECT_EQ(CountHits(leftOut, stray), 1);
    EXPECT_EQ(GetField(leftOut, "NumberOfReturnsOnSpeckles"), 1.0);
    EXPECT_EQ(CountReturnsOnAll(leftOut), static_cast<double>(scan->GetNumberOfPoints()));
  }
}

TEST(MapOfSpeckles, AreGroupsUpToTheMaximumSize)
{
  WallScan scan;
  for (const GapBeam& beam : GetSquare({ Middle, Middle }, 2))
  {
    scan.Set(beam, 2.0);
  }
  EXPECT_EQ(CountSpeckles(scan.Make(), 3), 0.0);
  EXPECT_EQ(CountSpeckles(scan.Make(), 4), 1.0);
}

TEST(MapOfSpeckles, StandOutByLessThanTheDepthStep)
{
  for (double height : { 0.04, 0.08, -0.04, -0.08 })
  {
    WallScan scan;
    const GapBeam dent = { Middle - 3, Middle + 5 };
    scan.Set(dent, scan.GetRange(dent) - height);
    for (const GapBeam& beam : GetSquare({ 10, 10 }, 2))
    {
      scan.Set(beam, scan.GetRange(beam) - height);
    }
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan.Make(), GapProperties{ 0, 4 });
    EXPECT_EQ(GetField(map, "NumberOfSpeckles"), 2.0) << height;
    EXPECT_EQ(GetField(map, "NumberOfReturnsOnSpeckles"), 5.0) << height;
    EXPECT_EQ(CountHits(map, dent), 2) << height;
    EXPECT_LE(GetLargestDistance(scan.Make(), map), 0.01) << height;
    EXPECT_EQ(CountSpeckles(scan.Make(), 3), 1.0) << height;
  }
  WallScan within;
  const GapBeam beam = { Middle, Middle };
  EXPECT_EQ(CountSpeckles(within.Set(beam, WallScan::Distance - 0.014).Make(), 4), 0.0);
}

TEST(MapOfSpeckles, StandOutOnOneSideEach)
{
  // The returns between two diagonal neighbours lie behind the lines through both.
  for (double height : { 0.025, 0.05 })
  {
    WallScan scan;
    for (const GapBeam& beam : { GapBeam{ 10, 10 }, GapBeam{ 11, 11 } })
    {
      scan.Set(beam, scan.GetRange(beam) - height);
    }
    EXPECT_EQ(CountSpeckles(scan.Make(), 1), 0.0) << height;
    EXPECT_EQ(CountSpeckles(scan.Make(), 2), 1.0) << height;
  }
}

TEST(MapOfSpeckles, AreNoEdgeAndNoCornerThatStandsOut)
{
  // A board in front of the wall, and its corner.
  WallScan scan;
  for (const GapBeam& beam : GetSquare({ 0, 0 }, Middle))
  {
    scan.Set(beam, scan.GetRange(beam) * (1.0 - 0.05 / WallScan::Distance));
  }
  EXPECT_EQ(CountSpeckles(scan.Make(), 4), 0.0);
}

TEST(MapOfSpeckles, AreNeverAThinThing)
{
  // A chair leg and a diagonal wire, each seen by one beam a turn or one turn a beam, one of them
  // with a lost beam.
  for (double range : { 2.0, 2.92 })
  {
    for (int slope : { -1, 0, 1 })
    {
      WallScan leg;
      WallScan broken;
      for (int i = 0; i < 20; ++i)
      {
        const GapBeam beam = { Middle + (slope == 0 ? 0 : i - 10), 10 + (slope < 0 ? 20 - i : i) };
        leg.Set(beam, range);
        broken.Set(beam, i % 4 == 2 ? 0.0 : range);
      }
      for (const WallScan* scan : { &leg, &broken })
      {
        vtkSmartPointer<vtkPolyData> map = MakeMap(scan->Make(), GapProperties{ 25, 4, false });
        EXPECT_EQ(GetField(map, "NumberOfSpeckles"), 0.0) << slope;
        EXPECT_LE(GetLargestDistance(scan->Make(), map), 0.01) << slope;
      }
    }
  }
}

TEST(MapOfSpeckles, MayBeSideBySideAndBesideGaps)
{
  WallScan scan;
  const std::vector<GapBeam> strays = { { Middle, Middle }, { Middle, Middle + 1 }, { 10, 10 },
    { 30, 30 } };
  scan.Set(strays[0], 1.0).Set(strays[1], 2.0);
  // A stray within a gap, and one beside a lost beam.
  std::vector<GapBeam> lost = GetSquare({ 9, 9 }, 3);
  lost.push_back({ 30, 31 });
  scan.Lose(lost).Set(strays[2], 1.0).Set(strays[3], 5.0);
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan.Make(), GapProperties{ 9, 4, false });
  EXPECT_EQ(GetField(map, "NumberOfSpeckles"), 4.0);
  EXPECT_EQ(GetField(map, "NumberOfClosedGaps"), 2.0);
  EXPECT_EQ(map->GetNumberOfCells(), CountTrianglesOfWall());
  for (const GapBeam& beam : strays)
  {
    EXPECT_EQ(CountHits(map, beam), 1);
  }
}

TEST(MapOfSpeckles, AreNotBesideFreeSpaceOrTheEdge)
{
  const GapBeam stray = { Middle, Middle };
  const GapBeam beside = { Middle, Middle + 1 };
  vtkSmartPointer<vtkPolyData> scan = WallScan().Set(stray, 2.0).Lose({ beside }).Make();
  EXPECT_EQ(CountSpeckles(scan, 1), 1.0);
  AddStatus(scan, { WallScan::GetBeamId(beside) }, vtkLMS3DScanFilter::NOTHING_MET);
  const auto count = [](vtkPolyData* some) {
    return GetField(MakeMap(some, GapProperties{ -1, 1 }), "NumberOfSpeckles");
  };
  EXPECT_EQ(count(scan), 0.0);
  AddStatus(scan, { WallScan::GetBeamId(beside) }, vtkLMS3DScanFilter::TOO_WEAK);
  EXPECT_EQ(count(scan), 1.0);
  EXPECT_EQ(CountSpeckles(WallScan().Set({ 0, Middle }, 2.0).Make(), 1), 0.0);
}

TEST(MapOfSpeckles, AreNotOnTheSurfaceAroundThem)
{
  // Close to walls, neighbouring returns of one surface differ by more than the depth step.
  for (const std::string& name : GetMapSceneNames())
  {
    const MapScene scene = MakeMapScene(name);
    for (double bound : { 0.01, 0.1 })
    {
      const GapProperties properties = { 0, 4, false, bound };
      EXPECT_TRUE(
        !scene.IsWhole || GetField(MakeMap(MakeScan(scene), properties), "NumberOfSpeckles") == 0.0)
        << name << ", " << bound;
    }
  }
}

TEST(MapOfSpeckles, AreNotBetweenTwoSurfacesAtDifferentDepths)
{
  // A plane passes through the last returns of both surfaces, if the beams between them are lost.
  WallScan scan;
  for (const GapBeam& beam : GetSquare({ 0, 0 }, WallScan::Size))
  {
    scan.Set(beam, beam.Turn < Middle ? 2.4 : 3.4);
  }
  scan.Lose(GetSquare({ Middle, Middle - 3 }, 2)).Lose(GetSquare({ Middle, Middle - 1 }, 2));
  scan.Lose(GetSquare({ Middle, Middle + 1 }, 2)).Lose(GetSquare({ Middle, Middle + 3 }, 2));
  EXPECT_EQ(CountSpeckles(scan.Set({ Middle, Middle }, 3.9).Make(), 1), 0.0);
}

TEST(MapOfSpeckles, AreBehindASurfaceOnlyIfItIsAroundThem)
{
  const auto count = [](double range)
  {
    WallScan scan;
    scan.Lose(GetSquare({ Middle, Middle }, 2)).Lose({ { Middle + 1, Middle - 1 } });
    return CountSpeckles(scan.Set({ Middle, Middle }, range).Make(), 1);
  };
  EXPECT_EQ(count(1.5), 1.0);
  EXPECT_EQ(count(4.5), 0.0);
}

TEST(MapOfSpeckles, AreReturnsOfThePlainGrid)
{
  // Noise beyond three quarters of the bound, and strays.
  Random random(13);
  WallScan scan;
  for (const GapBeam& beam : GetSquare({ 0, 0 }, WallScan::Size))
  {
    scan.Set(beam, scan.GetRange(beam) + random.Get(-0.01, 0.01));
  }
  scan.Set({ Middle, Middle }, 1.0);
  vtkSmartPointer<vtkPolyData> kept = MakeMap(scan.Make(), GapProperties{ 25, 1, true, 0.002 });
  ASSERT_GT(GetField(kept, "NumberOfReturnsOnGrid"), 0.0);
  EXPECT_EQ(GetField(kept, "NumberOfReturnsOnSpeckles"), 0.0);
  EXPECT_EQ(CountReturnsOnAll(kept), WallScan::Size * WallScan::Size);
  EXPECT_LE(GetLargestDistance(scan.Make(), kept), 1e-9);
  vtkSmartPointer<vtkPolyData> leftOut = MakeMap(scan.Make(), GapProperties{ 25, 1, false, 0.002 });
  EXPECT_EQ(GetField(leftOut, "NumberOfReturnsOnSpeckles"), 1.0);
  EXPECT_EQ(CountReturnsOnAll(leftOut), WallScan::Size * WallScan::Size);
}

TEST(MapOfSpeckles, LeaveTheMapOfTheRoomSmall)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
  scene.AlphaResolution = 181;
  scene.BetaResolution = 180;
  vtkSmartPointer<vtkPolyData> ideal = MakeScan(scene);
  const auto whole = static_cast<double>(MakeMap(ideal, GapProperties())->GetNumberOfCells());
  Random random(17);
  vtkSmartPointer<vtkPolyData> scan = AddStrays(ideal, 0.01, random);
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan, GapProperties{ 0, 4 });
  EXPECT_LE(static_cast<double>(map->GetNumberOfCells()), 3.0 * whole);
  EXPECT_GT(GetField(map, "NumberOfSpeckles"), 0.6 * 0.01 * 181 * 180);
  EXPECT_EQ(CountReturnsOnAll(map), static_cast<double>(scan->GetNumberOfPoints()));
}
