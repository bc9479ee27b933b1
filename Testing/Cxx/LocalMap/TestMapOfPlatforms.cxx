// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Maps of scans of all mountings, of mirrors beside the axis and of turning platforms.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"
#include "LocalMap/PlatformFixtures.h"

#include "vtkLMS3DMapComparison.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <utility>

namespace
{
const char* const Scenes[] = { "ClosedRoom", "FurnishedRoom", "Pole", "Stairs", "LShapedRoom",
  "BallInRoom" };

class EachPlatform : public testing::TestWithParam<TestPlatform>
{
};

std::string GetName(const testing::TestParamInfo<TestPlatform>& info)
{
  return info.param.Name;
}

bool IsCentredAndStepped(const TestPlatform& platform)
{
  return platform.AxisOffset == Vector{ 0.0, 0.0, 0.0 } && platform.TurnRate == 0.0;
}

// Compares the map with its scene as the sensor sees it.
vtkSmartPointer<vtkLMS3DMapComparison> Compare(
  vtkPolyData* scan, vtkPolyData* map, const MapScene& scene)
{
  auto comparison = vtkSmartPointer<vtkLMS3DMapComparison>::New();
  comparison->SetInputData(map);
  comparison->SetSceneData(scene.Surface);
  comparison->SetScanData(scan);
  comparison->SetNumberOfSamples(20000);
  EXPECT_EQ(UpdateAndGetError(comparison), "");
  return comparison;
}

// Counts edges of one triangle, and edges of two triangles in the same direction.
std::pair<int, int> CountOpenAndWrongEdges(vtkPolyData* map)
{
  std::multiset<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    for (int i = 0; i < 3; ++i)
    {
      edges.emplace(corners->GetId(i), corners->GetId((i + 1) % 3));
    }
  }
  int open = 0;
  int wrong = 0;
  for (const auto& edge : edges)
  {
    open += edges.count({ edge.second, edge.first }) == 0 ? 1 : 0;
    wrong += edges.count(edge) > 1 ? 1 : 0;
  }
  return { open, wrong };
}
} // namespace

TEST_P(EachPlatform, IsMappedWithinTheBound)
{
  for (const char* name : Scenes)
  {
    SCOPED_TRACE(name);
    const MapScene scene = MakeMapScene(name);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene, GetParam());
    for (double bound : { 0.002, 0.01, 0.05 })
    {
      SCOPED_TRACE(bound);
      vtkSmartPointer<vtkPolyData> map = MakeMap(scan, bound);
      EXPECT_LE(GetLargestDistance(scan, map), bound + 1e-9);
      EXPECT_LE(GetField(map, "LargestDeviation"), bound + 1e-9);
      EXPECT_EQ(GetField(map, "NumberOfReturns"), scan->GetNumberOfPoints());
      EXPECT_EQ(CountOpenAndWrongEdges(map).second, 0);
      std::cout << name << ' ' << bound << ' ' << map->GetNumberOfCells() << " triangles, "
                << GetField(map, "NumberOfPatches") << " patches, on grid "
                << GetField(map, "NumberOfReturnsOnGrid") << " on facets "
                << GetField(map, "NumberOfReturnsOnFacets") << '\n';
    }
  }
}

TEST_P(EachPlatform, LeavesFreeSpaceFree)
{
  for (const char* name : Scenes)
  {
    SCOPED_TRACE(name);
    const MapScene scene = MakeMapScene(name);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene, GetParam());
    for (double bound : { 0.0, 0.01 })
    {
      SCOPED_TRACE(bound);
      vtkSmartPointer<vtkPolyData> map = MakeMap(scan, bound);
      vtkSmartPointer<vtkLMS3DMapComparison> comparison = Compare(scan, map, scene);
      // A scan in steps of 2 degrees rounds creases off.
      EXPECT_LT(comparison->GetAreaInFreeSpace(), 0.13 * comparison->GetMapArea());
      EXPECT_GT(comparison->GetCompleteness(), 0.75);
      EXPECT_GE(comparison->GetReturnsWithinTolerance(), bound > 0.0 ? 1.0 : 0.98);
    }
  }
}

TEST_P(EachPlatform, HasALawfulMap)
{
  if (!IsCentredAndStepped(GetParam()))
  {
    return;
  }
  for (const char* name : Scenes)
  {
    SCOPED_TRACE(name);
    const MapScene scene = MakeMapScene(name);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene, GetParam());
    for (double bound : { 0.0, 0.01 })
    {
      const MapVerdict verdict =
        ExpectLawful(ToYawing(scan), MakeMap(scan, bound), { bound, 0.1, scene.Surface });
      if (scene.IsWhole && !GetParam().IsFanAlongAxis())
      {
        ExpectClosed(verdict);
      }
    }
  }
}

namespace
{
// Fails the test if two maps differ by more than rounding.
void ExpectSameMap(vtkPolyData* map, vtkPolyData* expected)
{
  ASSERT_EQ(map->GetNumberOfPoints(), expected->GetNumberOfPoints());
  ASSERT_EQ(map->GetNumberOfCells(), expected->GetNumberOfCells());
  double largest = 0.0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    Vector point, other;
    map->GetPoint(i, point.data());
    expected->GetPoint(i, other.data());
    largest = std::max(largest, GetLength(point - other));
  }
  EXPECT_LT(largest, 1e-8);
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeRoomScan(int mounting)
{
  auto scan = vtkSmartPointer<vtkLMS3DScanFilter>::New();
  scan->SetInputDataObject(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMounting(mounting);
  return scan;
}

// A wall of 40 m at 2 m, scanned in steps of `step` degrees by a platform that turns one degree in a fan.
vtkSmartPointer<vtkPolyData> ScanWall(double step, const Vector& axisOffset)
{
  SceneBuilder builder;
  builder.AddQuad(
    { 2.0, -20.0, -20.0 }, { 2.0, 20.0, -20.0 }, { 2.0, 20.0, 20.0 }, { 2.0, -20.0, 20.0 });
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(builder.GetSurface());
  scan->SetAlphaRange(-60.0, 60.0);
  scan->SetAlphaResolution(static_cast<int>(120.0 / step) + 1);
  scan->SetBetaRange(-60.0, 60.0);
  scan->SetBetaResolution(121);
  scan->SetTurnRate(75.0 * step);
  scan->SetAxisOffset(axisOffset.data());
  scan->Update();
  return scan->GetOutput();
}
} // namespace

TEST(MapOfPlatforms, OfPitchingIsThatOfATurnedYawingSensor)
{
  auto pitching = MakeRoomScan(vtkLMS3DScanFilter::PITCHING);
  auto yawing = MakeRoomScan(vtkLMS3DScanFilter::YAWING);
  yawing->SetOrientation(-90.0, 0.0, 0.0);
  pitching->Update();
  yawing->Update();
  for (double bound : { 0.0, 0.01 })
  {
    ExpectSameMap(MakeMap(pitching->GetOutput(), bound), MakeMap(yawing->GetOutput(), bound));
  }
}

TEST(MapOfPlatforms, OfRollingIsThatOfATurnedYawingSensor)
{
  auto rolling = MakeRoomScan(vtkLMS3DScanFilter::ROLLING);
  rolling->SetBetaRange(0.0, 180.0);
  rolling->SetBetaResolution(181);
  auto yawing = MakeRoomScan(vtkLMS3DScanFilter::YAWING);
  yawing->SetOrientation(90.0, 0.0, 90.0);
  yawing->SetAlphaRange(0.0, 90.0);
  yawing->SetAlphaResolution(181);
  rolling->Update();
  yawing->Update();
  for (double bound : { 0.0, 0.01 })
  {
    vtkSmartPointer<vtkPolyData> map = MakeMap(rolling->GetOutput(), bound);
    ExpectSameMap(map, MakeMap(yawing->GetOutput(), bound));
    if (bound > 0.0)
    {
      EXPECT_EQ(GetField(map, "NumberOfReturns"), 361 * 181);
      EXPECT_EQ(GetField(map, "NumberOfReturnsOnRepeatedTurns"), 361);
    }
  }
}

TEST(MapOfPlatforms, OfYawingTopIsThatOfAYawingSensor)
{
  auto top = MakeRoomScan(vtkLMS3DScanFilter::YAWING_TOP);
  top->SetBetaRange(0.0, 360.0); // The second half repeats the first.
  auto yawing = MakeRoomScan(vtkLMS3DScanFilter::YAWING);
  yawing->SetAlphaRange(0.0, 90.0);
  yawing->SetAlphaResolution(181);
  top->Update();
  yawing->Update();
  for (double bound : { 0.0, 0.01 })
  {
    ExpectSameMap(MakeMap(top->GetOutput(), bound), MakeMap(yawing->GetOutput(), bound));
  }
}

// Interlaced fans form a comb.
TEST(MapOfPlatforms, OfAWallIsOnePatchIfThePlatformTurns)
{
  for (const Vector& offset : { Vector{ 0.0, 0.0, 0.0 }, Vector{ 0.1, 0.05, 0.02 } })
  {
    for (double step : { 1.0, 0.5, 0.25 })
    {
      SCOPED_TRACE(step);
      vtkSmartPointer<vtkPolyData> scan = ScanWall(step, offset);
      vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.01);
      EXPECT_EQ(GetField(map, "NumberOfPatches"), 1);
      // Only the ends of the comb at both sides of the wall.
      EXPECT_LT(map->GetNumberOfCells(), step == 1.0 ? 40 : 600);
      EXPECT_LE(GetLargestDistance(scan, map), 0.01);
      const vtkIdType cells = 2 * 120 * static_cast<vtkIdType>(120.0 / step);
      EXPECT_EQ(MakeMap(scan, 0.0)->GetNumberOfCells(), cells);
    }
  }
}

// The halves of the fan have different elevations.
TEST(MapOfPlatforms, KeepsTheBoundIfTheFanIsNotSymmetric)
{
  for (int resolution : { 136, 135, 100 })
  {
    SCOPED_TRACE(resolution);
    auto scan = MakeRoomScan(vtkLMS3DScanFilter::ROLLING);
    scan->SetAlphaRange(-90.0, 45.0);
    scan->SetAlphaResolution(resolution);
    scan->SetBetaRange(0.0, 178.0);
    scan->SetBetaResolution(90);
    scan->Update();
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan->GetOutput(), 0.01);
    EXPECT_LE(GetLargestDistance(scan->GetOutput(), map), 0.01);
    EXPECT_EQ(GetField(map, "NumberOfReturnsOnGrid"), 0);
    EXPECT_LT(GetField(map, "NumberOfReturnsOnFacets"), 0.001 * GetField(map, "NumberOfReturns"));
  }
}

INSTANTIATE_TEST_SUITE_P(
  MapOfPlatforms, EachPlatform, testing::ValuesIn(GetTestPlatforms()), GetName);
