// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Maps of scans of all mountings, of mirrors beside the axis and of turning platforms.
 */
#include "Fixtures/SceneFixtures.h"
#include "LocalMap/PlatformFixtures.h"

#include "vtkLMS3DMapComparison.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <set>
#include <string>
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

// Facets are for returns beyond the axis and for returns beside a fault.
void ExpectFewTriangles(vtkPolyData* map, vtkPolyData* centred, double ratio = 2.0)
{
  const double facets = GetField(map, "NumberOfReturnsOnFacets");
  EXPECT_EQ(GetField(map, "NumberOfReturnsOnGrid"), 0.0);
  EXPECT_LE(map->GetNumberOfCells() - facets, ratio * centred->GetNumberOfCells() + 100.0);
  EXPECT_LE(facets, 0.025 * GetField(map, "NumberOfReturns"));
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
    }
  }
}

// A fault at one place must not make the plain grid of the whole scan.
TEST_P(EachPlatform, IsMappedWithFewTriangles)
{
  TestPlatform centred = GetParam();
  centred.AxisOffset = { 0.0, 0.0, 0.0 };
  centred.TurnRate = 0.0;
  for (const char* name : Scenes)
  {
    SCOPED_TRACE(name);
    const MapScene scene = MakeMapScene(name);
    // Only maps of mirrors on the axis are simplified on curved surfaces.
    const double ratio = std::string(name) == "BallInRoom" ? 3.0 : 2.0;
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene, GetParam());
    for (double bound : { 0.01, 0.02 })
    {
      SCOPED_TRACE(bound);
      ExpectFewTriangles(MakeMap(scan, bound), MakeMap(MakeScan(scene, centred), bound), ratio);
    }
  }
}

TEST(MapOfPlatforms, HasFewTrianglesInTheRoom)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
#ifndef LMS3D_FEWER_BEAMS
  scene.AlphaResolution = 361;
  scene.BetaResolution = 360;
#endif
  const auto makeMap = [&](const Vector& offset, double turnRate)
  {
    vtkNew<vtkLMS3DScanFilter> filter;
    filter->SetInputData(scene.Surface);
    filter->SetPosition(0.3, -0.2, 1.0);
    filter->SetAlphaResolution(scene.AlphaResolution);
    filter->SetBetaResolution(scene.BetaResolution);
    filter->SetAxisOffset(offset.data());
    filter->SetTurnRate(turnRate);
    filter->Update();
    vtkSmartPointer<vtkPolyData> map = MakeMap(filter->GetOutput(), 0.02);
    EXPECT_LE(GetLargestDistance(filter->GetOutput(), map), 0.02 + 1e-9);
    return map;
  };
  vtkSmartPointer<vtkPolyData> centred = makeMap({ 0.0, 0.0, 0.0 }, 0.0);
  for (const Vector& offset : { Vector{ 0.1, 0.0, 0.0 }, Vector{ 0.0, 0.2, 0.0 },
         Vector{ -0.1, 0.05, 0.1 }, Vector{ 0.0, 0.0, 0.2 } })
  {
    SCOPED_TRACE(offset[0]);
    ExpectFewTriangles(makeMap(offset, 0.0), centred);
  }
  ExpectFewTriangles(makeMap({ 0.0, 0.0, 0.0 }, 10.0), centred);
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
      EXPECT_GE(comparison->GetReturnsWithinTolerance(), bound > 0.0 ? 1.0 : 0.9);
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

INSTANTIATE_TEST_SUITE_P(
  MapOfPlatforms, EachPlatform, testing::ValuesIn(GetTestPlatforms()), GetName);
