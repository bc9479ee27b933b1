// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with a trajectory: its times and its poses.
 */
#include "Scan/TrajectoryFixtures.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
double GetEntry(vtkLMS3DScanFilter* scan, int row, int column)
{
  vtkDataArray* pose = scan->GetOutput()->GetFieldData()->GetArray("SensorToWorld");
  return pose->GetComponent(4 * row + column, 0);
}

Point GetPosition(vtkLMS3DScanFilter* scan)
{
  return { GetEntry(scan, 0, 3), GetEntry(scan, 1, 3), GetEntry(scan, 2, 3) };
}

void ExpectAxis(vtkLMS3DScanFilter* scan, int column, const Point& axis)
{
  for (int row = 0; row < 3; ++row)
  {
    EXPECT_NEAR(GetEntry(scan, row, column), axis[row], 1e-15) << column;
  }
}
} // namespace

TEST(LMS3DScanTrajectory, NumbersThePosesWithoutTimes)
{
  auto scan = MakeScanAlong(MakePoses(ThreePositions));
  for (int port : { 0, 1 })
  {
    EXPECT_EQ(GetTimes(scan, port), (std::vector<double>{ 0, 1, 2 }));
    const double* range =
      scan->GetOutputInformation(port)->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    EXPECT_EQ(range[0], 0.0);
    EXPECT_EQ(range[1], 2.0);
  }
}

TEST(LMS3DScanTrajectory, GivesTheScanOfTheLastPoseWhoseTimeHasCome)
{
  auto poses = MakePoses(ThreePositions);
  AddArray(poses, "Time", 1, { 10, 11, 15 });
  auto scan = MakeScanAlong(poses);
  EXPECT_EQ(GetTimes(scan), (std::vector<double>{ 10, 11, 15 }));
  struct
  {
    double Asked;
    int Step;
    double Given;
  } const cases[] = { { 10, 0, 10 }, { 11, 1, 11 }, { 15, 2, 15 }, { 14.9, 1, 11 }, { 10.5, 0, 10 },
    { -3, 0, 10 }, { 99, 2, 15 } };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(c.Asked);
    scan->UpdateTimeStep(c.Asked);
    EXPECT_EQ(GetPosition(scan), ThreePositions[c.Step]);
    EXPECT_EQ(scan->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), c.Given);
    EXPECT_EQ(
      scan->GetRangeImage()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), c.Given);
  }
}

TEST(LMS3DScanTrajectory, StartsWithTheFirstPose)
{
  auto scan = MakeScanAlong(MakePoses({ { 0, 1, 0 }, { 0, 2, 0 } }));
  scan->SetPosition(3.0, 0.0, 0.0);
  scan->Update();
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 1, 0 }));
}

TEST(LMS3DScanTrajectory, BuildsOnceForAllSteps)
{
  auto scan = MakeScanAlong(MakePoses(ThreePositions));
  scan->UpdateTimeStep(0);
  const vtkMTimeType built = scan->GetBuildTime();
  const std::uint64_t first = Hash(scan->GetOutput());
  scan->UpdateTimeStep(1);
  EXPECT_NE(Hash(scan->GetOutput()), first);
  scan->UpdateTimeStep(2);
  scan->UpdateTimeStep(0);
  EXPECT_EQ(Hash(scan->GetOutput()), first);
  EXPECT_EQ(scan->GetBuildTime(), built);
}

TEST(LMS3DScanTrajectory, MeasuresAsASensorThatStandsThere)
{
  auto scan = MakeScanAlong(MakePoses(ThreePositions));
  scan->SetOrientation(10.0, 20.0, 30.0);
  scan->UpdateTimeStep(2);
  const std::uint64_t moved = Hash(scan->GetOutput());

  auto standing = MakeScan(MakeBall(5.0));
  SetGrid(standing, 9, 8);
  standing->SetOrientation(10.0, 20.0, 30.0);
  standing->SetPosition(1.0, 2.0, 0.0);
  standing->Update();
  EXPECT_EQ(moved, Hash(standing->GetOutput()));
}

TEST(LMS3DScanTrajectory, IsForgottenWhenItIsTakenAway)
{
  auto scan = MakeScanAlong(MakePoses(ThreePositions));
  scan->UpdateTimeStep(2);
  scan->SetTrajectoryData(nullptr);
  scan->SetPosition(0.0, 0.0, 1.0);
  EXPECT_TRUE(GetTimes(scan).empty());
  scan->Update();
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 0, 1 }));
  EXPECT_FALSE(scan->GetOutput()->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()));
}

TEST(LMS3DScanTrajectory, NoticesANewTrajectory)
{
  auto poses = MakePoses(ThreePositions);
  auto scan = MakeScanAlong(poses);
  scan->UpdateTimeStep(1);
  poses->GetPoints()->InsertNextPoint(0, 0, 3);
  poses->GetPoints()->Modified();
  EXPECT_EQ(GetTimes(scan).size(), 4u);
  scan->UpdateTimeStep(3);
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 0, 3 }));
}

TEST(LMS3DScanTrajectory, TakesAnOlderTrajectoryInPlaceOfANewerOne)
{
  auto older = MakePoses({ { 0, 0, 1 } });
  auto newer = MakePoses(ThreePositions);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(newer);
  auto scan = MakeScanAlong(nullptr);
  scan->SetTrajectoryConnection(producer->GetOutputPort());
  scan->Update();
  EXPECT_EQ(GetTimes(scan).size(), 3u);
  producer->SetOutput(older);
  scan->Update();
  EXPECT_EQ(GetTimes(scan).size(), 1u);
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 0, 1 }));
}

TEST(LMS3DScanTrajectory, TurnsByQuaternions)
{
  const double half = std::sqrt(0.5);
  auto poses = MakePoses({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } });
  // None, 90 degrees about z, and the same again at a length that no square holds.
  AddArray(
    poses, "Orientation", 4, { 1, 0, 0, 0, half, 0, 0, half, half * 1e300, 0, 0, half * 1e300 });
  auto scan = MakeScanAlong(poses);
  scan->UpdateTimeStep(0);
  ExpectAxis(scan, 0, { 1, 0, 0 });
  ExpectAxis(scan, 2, { 0, 0, 1 });
  for (int step : { 1, 2 })
  {
    scan->UpdateTimeStep(step);
    ExpectAxis(scan, 0, { 0, 1, 0 });
    ExpectAxis(scan, 1, { -1, 0, 0 });
    ExpectAxis(scan, 2, { 0, 0, 1 });
  }
}

TEST(LMS3DScanTrajectory, FollowsAPolylineInItsOrder)
{
  // Up the x axis, standing, round a corner, and straight up.
  auto poses = MakePoses({ { 1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 2 } });
  AddLine(poses, { 1, 0, 2, 3, 4, 4 });
  auto scan = MakeScanAlong(poses);
  EXPECT_EQ(GetTimes(scan).size(), 6u);
  const double half = std::sqrt(0.5);
  const double slope = std::sqrt(0.2);
  const Point positions[] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 2 },
    { 1, 1, 2 } };
  const Point ahead[] = { { 1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, slope, 2 * slope },
    { 0, 0, 1 }, { 0, 0, 1 } };
  const Point left[] = { { 0, 1, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { -1, 0, 0 }, { -1, 0, 0 },
    { -1, 0, 0 } };
  for (int step = 0; step < 6; ++step)
  {
    SCOPED_TRACE(step);
    scan->UpdateTimeStep(step);
    EXPECT_EQ(GetPosition(scan), positions[step]);
    ExpectAxis(scan, 0, ahead[step]);
    ExpectAxis(scan, 1, left[step]);
  }
  poses->GetPoints()->SetPoint(3, 2, 1, 0);
  poses->GetPoints()->Modified();
  scan->UpdateTimeStep(2);
  ExpectAxis(scan, 0, { half, half, 0 });
}
