// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Maps of mountings that equal maps of turned sensors, and of fans that are combs or not
 * symmetric.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"
#include "LocalMap/PlatformFixtures.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>

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

// A wall of 40 m at 2 m, scanned in steps of `step` degrees by a platform that turns one degree in
// a fan.
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

TEST(MapOfMountings, OfPitchingIsThatOfATurnedYawingSensor)
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

TEST(MapOfMountings, OfRollingIsThatOfATurnedYawingSensor)
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

TEST(MapOfMountings, OfYawingTopIsThatOfAYawingSensor)
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
TEST(MapOfMountings, OfAWallIsOnePatchIfThePlatformTurns)
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
TEST(MapOfMountings, KeepsTheBoundIfTheFanIsNotSymmetric)
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
