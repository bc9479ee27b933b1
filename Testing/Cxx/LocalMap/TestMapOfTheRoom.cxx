// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the size of the local map of Data/room.wrl, its independence of threads, and invalid
 * input.
 */
#include "Fixtures/ProgressListener.h"
#include "LocalMap/MapFixtures.h"
#include "LocalMap/PlainGridFixtures.h"

#include <vtkCell.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr std::uint64_t Seed = 20090403;

// The closed grid has two triangles in each cell, one at the poles.
constexpr double TrianglesOfFullGrid = 2.0 * 360.0 * 359.0;

/// The paper's scan.
MapScene GetRoom()
{
  MapScene scene = MakeMapScene("FurnishedRoom");
#ifdef LMS3D_FEWER_BEAMS
  scene.AlphaResolution = 91;
  scene.BetaResolution = 90;
#else
  scene.AlphaResolution = 361;
  scene.BetaResolution = 360;
#endif
  return scene;
}

/// Degrees.
double GetSmallestAngle(vtkPolyData* map, vtkIdType cell)
{
  double smallest = 180.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const auto get = [&](int i)
    {
      Vector point;
      map->GetPoint(map->GetCell(cell)->GetPointId((corner + i) % 3), point.data());
      return point;
    };
    const Vector to = get(1) - get(0);
    const Vector from = get(2) - get(0);
    smallest = std::min(
      smallest, vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(to.data(), from.data())));
  }
  return smallest;
}
} // namespace

TEST(MapOfTheRoom, KeepsTheLaws)
{
  const MapScene scene = GetRoom();
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  for (double bound : { 0.0, 0.001, 0.01 })
  {
    SCOPED_TRACE(bound);
    ExpectLawful(scan, { bound, 0.1, scene.Surface });
  }
}

TEST(MapOfTheRoom, KeepsTheLawsWithNoise)
{
  const MapScene scene = GetRoom();
  Random random(Seed);
  vtkSmartPointer<vtkPolyData> scan = AddNoise(MakeScan(scene), 0.005, random);
  for (double bound : { 0.01, 0.02 })
  {
    SCOPED_TRACE(bound);
    ExpectLawful(scan, { bound, 0.1, scene.Surface, 0.02 });
  }
}

TEST(MapOfTheRoom, IsClosedWhereTheRoomIsEmpty)
{
  for (const char* name : { "ClosedRoom", "TurnedRoom" })
  {
    MapScene scene = MakeMapScene(name);
    scene.AlphaResolution = GetRoom().AlphaResolution;
    scene.BetaResolution = GetRoom().BetaResolution;
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    for (double bound : { 0.0, 0.01 })
    {
      SCOPED_TRACE(std::string(name) + " within " + std::to_string(bound));
      ExpectClosed(ExpectLawful(scan, { bound, 0.1, scene.Surface }));
    }
  }
}

#ifndef LMS3D_FEWER_BEAMS
TEST(MapOfTheRoom, IsSmall)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(GetRoom());
  EXPECT_LE(MakeMap(scan, 0.01)->GetNumberOfCells(), 0.0051 * TrianglesOfFullGrid);
  Random random(Seed);
  EXPECT_LE(
    MakeMap(AddNoise(scan, 0.005, random), 0.02)->GetNumberOfCells(), 0.0064 * TrianglesOfFullGrid);
}

// Planes within a large bound cut the corners of the room. Patches that fail the proof for this
// reason must not fall apart. The order of the patches' growth makes small differences.
TEST(MapOfTheRoom, NeedsNoMoreTrianglesForLargerBounds)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(GetRoom());
  double fewest = TrianglesOfFullGrid;
  for (double bound : { 1e-4, 1e-3, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 2.0 })
  {
    const auto triangles = static_cast<double>(MakeMap(scan, bound)->GetNumberOfCells());
    EXPECT_LE(triangles, 1.03 * fewest) << "for " << bound << " m";
    fewest = std::min(fewest, triangles);
  }
}
#endif

// Even for a bound far above the ranges, no vertex lies behind the sensor.
TEST(MapOfTheRoom, KeepsTheLawsForBoundsBeyondAllRanges)
{
  MapScene scene = GetRoom();
  for (const std::array<int, 2>& beams : { std::array<int, 2>{ 9, 3 }, { 19, 18 }, { 61, 60 } })
  {
    scene.AlphaResolution = beams[0];
    scene.BetaResolution = beams[1];
    Random random(Seed);
    vtkSmartPointer<vtkPolyData> scan =
      Keep(AddNoise(MakeScan(scene), 0.3, random), [&](vtkIdType) { return random.Get() < 0.8; });
    for (double bound : { 5.0, 1e3, std::numeric_limits<double>::max() })
    {
      SCOPED_TRACE(bound);
      ExpectLawful(scan, { bound, 0.1, scene.Surface, 1.2 });
    }
  }
}

// Slivers occur only where the bound needs them.
TEST(MapOfTheRoom, HasSoundShapes)
{
  vtkSmartPointer<vtkPolyData> map = MakeMap(MakeScan(GetRoom()), 0.01);
  std::vector<double> angles;
  angles.reserve(static_cast<std::size_t>(map->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    angles.push_back(GetSmallestAngle(map, cell));
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_GT(angles[angles.size() / 2], 15.0);
  EXPECT_LT(std::count_if(angles.begin(), angles.end(), [](double angle) { return angle < 1.0; }),
    0.03 * static_cast<double>(angles.size()));
}

TEST(MapOfTheRoom, IsEmptyWhereTheUserStopsIt)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(GetRoom());
  for (double share : { 0.2, 0.5 })
  {
    vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
    filter->SetInputDataObject(scan);
    {
      const ProgressListener stopper(
        filter, [&](double progress) { filter->SetAbortExecute(progress >= share ? 1 : 0); });
      filter->Update();
    }
    EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << share;

    filter->AbortExecuteOff();
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 100) << share;
  }
}

TEST(MapOfTheRoom, IsTheSameForAnyNumberOfThreads)
{
  Random random(Seed);
  MapScene scene = GetRoom();
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  vtkSmartPointer<vtkPolyData> noisy = AddNoise(scan, 0.005, random);
  // More threads than cores.
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  for (vtkPolyData* input : { scan.Get(), noisy.Get() })
  {
    for (double bound : { 0.0, 0.01, 0.05 })
    {
      SCOPED_TRACE(bound);
      const std::uint64_t alone = HashMap(MakeMap(input, bound, 1));
      for (int count : { 2, 3, 8 })
      {
        EXPECT_EQ(HashMap(MakeMap(input, bound, count)), alone) << count;
      }
    }
  }
}

TEST(MapOfTheRoom, HasAnErrorOfOneCentimetreByDefault)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  EXPECT_EQ(filter->GetMaximumError(), 0.01);
  filter->SetMaximumError(-1.0);
  EXPECT_EQ(filter->GetMaximumError(), 0.0);
}

TEST(MapOfTheRoom, IsRefusedForBadReturns)
{
  MapScene scene = GetRoom();
  scene.AlphaResolution = 19;
  scene.BetaResolution = 18;
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 0.0, -1.0 })
  {
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    scan->GetPointData()->GetArray("Range")->SetTuple1(7, bad);
    ExpectRefused(scan, "Return 7 of the scan has the Range");
  }
  vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
  scan->GetPointData()->GetArray("BeamId")->SetTuple1(7, 3);
  ExpectRefused(scan, "Return 7 of the scan has the BeamId");
  for (const char* name : { "Range", "BeamId" })
  {
    scan = MakeScan(scene);
    scan->GetPointData()->RemoveArray(name);
    ExpectRefused(scan, name);
  }
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    scan = MakeScan(scene);
    scan->GetFieldData()->GetArray(name)->SetComponent(
      0, 0, std::numeric_limits<double>::quiet_NaN());
    ExpectRefused(scan, name);
  }
}
