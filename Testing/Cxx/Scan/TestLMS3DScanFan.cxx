// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fans that are cast without the pipeline: they equal the updates of a scan of one turn.
 */
#include "Scan/DetectionFixtures.h"
#include "Scan/DeviceFixtures.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace
{
using Filter = vtkLMS3DScanFilter;

// Between two poses of MakeShortDrive.
constexpr double Time = 6.4;

/// The room between a floor and a black ceiling, with limits that beams in all directions exceed.
vtkSmartPointer<vtkPolyData> MakeFloorAndCeiling()
{
  auto scene = Join(Join(MakeFloor(30.0, -1.0), MakeFloor(2.0, 3.0)), MakeFloor(0.05, 1.3));
  SetReflectances(scene, { 1.0, 0.0, 1.0 });
  return scene;
}

vtkSmartPointer<Filter> MakeLimitedScan(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  SetGrid(scan, 181, 7);
  scan->SetPosition(0.1, -0.2, 1.0);
  scan->SetMinimumRange(0.5);
  scan->SetMaximumRange(9.0);
  scan->SetRangeAtTenPercent(20.0);
  scan->SetReflectanceArray("Reflectance");
  return scan;
}

/// Fails the test unless the fan equals the range image of an update, to the bit.
void ExpectFanOfUpdate(Filter* fan, Filter* update, double beta)
{
  vtkNew<vtkDoubleArray> ranges;
  vtkNew<vtkUnsignedCharArray> status;
  EXPECT_TRUE(fan->CastFan(beta, Time, ranges, status));
  update->SetBetaRange(beta, beta);
  update->SetBetaResolution(1);
  update->ComputeStatusOn();
  update->UpdateTimeStep(Time);
  vtkPointData* image = update->GetRangeImage()->GetPointData();
  EXPECT_EQ(Hash(ranges), Hash(image->GetArray("Range")));
  EXPECT_EQ(Hash(status), Hash(image->GetArray("Status")));
}

std::string GetErrorOfFan(Filter* scan, double beta)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = scan->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkDoubleArray> ranges;
  EXPECT_FALSE(scan->CastFan(beta, 0.0, ranges, nullptr));
  scan->RemoveObserver(tag);
  return observer->GetErrorMessage();
}
} // namespace

TEST(LMS3DScanFan, EqualsAnUpdateForEachDevice)
{
  auto scene = MakeFloorAndCeiling();
  std::vector<Device> devices = GetDevices();
  devices.push_back({ "Default", [](Filter*) {} });
  for (const Device& device : devices)
  {
    SCOPED_TRACE(device.Name);
    auto fan = MakeLimitedScan(scene);
    auto update = MakeLimitedScan(scene);
    device.Apply(fan);
    device.Apply(update);
    for (double beta : { 0.0, 33.25, -400.0 })
    {
      ExpectFanOfUpdate(fan, update, beta);
    }
  }
}

TEST(LMS3DScanFan, HasEachStatus)
{
  auto scan = MakeLimitedScan(MakeFloorAndCeiling());
  vtkNew<vtkDoubleArray> ranges;
  vtkNew<vtkUnsignedCharArray> status;
  std::set<int> found;
  for (int turn = 0; turn < 36; ++turn)
  {
    ASSERT_TRUE(scan->CastFan(10.0 * turn, 0.0, ranges, status));
    for (vtkIdType beam = 0; beam < status->GetNumberOfValues(); ++beam)
    {
      found.insert(status->GetValue(beam));
    }
  }
  EXPECT_EQ(found,
    (std::set<int>{ Filter::RETURN, Filter::NOTHING_MET, Filter::BEYOND_RANGE, Filter::TOO_WEAK,
      Filter::TOO_NEAR }));
}

TEST(LMS3DScanFan, LeavesTheOutputs)
{
  auto scan = MakeLimitedScan(MakeFloorAndCeiling());
  EXPECT_EQ(UpdateAndGetError(scan), "");
  const std::uint64_t outputs = HashOutputs(scan);
  const vtkMTimeType time = scan->GetOutput()->GetMTime();
  vtkNew<vtkDoubleArray> ranges;
  EXPECT_TRUE(scan->CastFan(12.0, 0.0, ranges, nullptr));
  EXPECT_EQ(ranges->GetNumberOfValues(), 181);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetMTime(), time);
  scan->Modified();
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), outputs);
}

TEST(LMS3DScanFan, FollowsTheSceneAndTheBeams)
{
  auto scene = MakeBall(2.0);
  auto scan = MakeScan(scene);
  scan->SetAlphaResolution(5);
  vtkNew<vtkDoubleArray> ranges;
  EXPECT_TRUE(scan->CastFan(0.0, 0.0, ranges, nullptr));
  EXPECT_EQ(ranges->GetNumberOfValues(), 5);
  EXPECT_NEAR(ranges->GetValue(0), 2.0, 1e-6);
  ScaleAndMove(scene, 2.0, { 0.0, 0.0, 0.0 });
  scene->Modified();
  scan->SetAlphaResolution(3);
  EXPECT_TRUE(scan->CastFan(0.0, 0.0, ranges, nullptr));
  EXPECT_EQ(ranges->GetNumberOfValues(), 3);
  EXPECT_NEAR(ranges->GetValue(0), 4.0, 1e-6);
}

TEST(LMS3DScanFan, ReportsErrors)
{
  vtkNew<Filter> empty;
  EXPECT_NE(GetErrorOfFan(empty, 0.0).find("There is no scene"), std::string::npos);
  auto scan = MakeScan(MakeBall(2.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(GetErrorOfFan(scan, nan).find("platform angle is not finite"), std::string::npos);
  vtkNew<vtkTest::ErrorObserver> observer;
  scan->AddObserver(vtkCommand::ErrorEvent, observer);
  EXPECT_FALSE(scan->CastFan(0.0, 0.0, nullptr, nullptr));
  EXPECT_NE(observer->GetErrorMessage().find("no array for the ranges"), std::string::npos);
  vtkNew<vtkPolyData> nothing;
  EXPECT_NE(GetErrorOfFan(MakeScan(nothing), 0.0).find("polygons"), std::string::npos);
  scan->SetTrajectoryData(nothing);
  EXPECT_NE(GetErrorOfFan(scan, 0.0).find("trajectory"), std::string::npos);
}
