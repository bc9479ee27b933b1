// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with a sensor that moves during the scan.
 */
#include "Scan/DeviceFixtures.h"
#include "Scan/TrajectoryFixtures.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
const Point Sizes = { 3.0, 2.0, 1.5 };

std::vector<double> GetTuple(vtkLMS3DScanFilter* scan, const char* name, vtkIdType i)
{
  vtkDataArray* array = GetArray(scan, name);
  std::vector<double> tuple(array->GetNumberOfComponents());
  array->GetTuple(i, tuple.data());
  return tuple;
}

vtkSmartPointer<vtkPolyData> MakePose(
  const std::vector<double>& position, const std::vector<double>& orientation)
{
  auto pose = MakePoses({ { position[0], position[1], position[2] } });
  AddArray(pose, "Orientation", 4, orientation);
  return pose;
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeDrivingScan(vtkDataObject* scene, int beams, int turns)
{
  auto scan = MakeScan(scene);
  SetGrid(scan, beams, turns);
  // Shorter than the scan, so that it passes two poses and rests at the end.
  scan->SetTrajectoryData(MakeShortDrive(0.3 * turns / 75.0));
  scan->MotionDuringScanOn();
  scan->ComputePosesOn();
  return scan;
}
} // namespace

TEST(LMS3DScanMotion, MeasuresAsASensorThatRestsAtEachPose)
{
  auto room = ReadRoom();
  auto scan = MakeDrivingScan(room, 19, 24);
  scan->SetAxisOffset(0.1, 0.02, 0.03);
  scan->Update();
  auto resting = MakeScan(room);
  SetGrid(resting, 1, 1);
  resting->SetAxisOffset(0.1, 0.02, 0.03);
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  const std::vector<double> beta = GetValues(scan, "Beta");
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); i += 3)
  {
    resting->SetTrajectoryData(
      MakePose(GetTuple(scan, "SensorPosition", i), GetTuple(scan, "SensorOrientation", i)));
    resting->SetAlphaRange(alpha[i], alpha[i]);
    resting->SetBetaRange(beta[i], beta[i]);
    resting->Update();
    ASSERT_EQ(resting->GetOutput()->GetNumberOfPoints(), 1);
    EXPECT_NEAR(GetRange(resting, 0), GetRange(scan, i), 1e-12) << i;
    EXPECT_EQ(GetValues(resting, "CellId")[0], GetValues(scan, "CellId")[i]) << i;
  }
}

// A drive along a corridor: each return, put back with the pose of its beam, lies on a wall.
TEST(LMS3DScanMotion, UndistortedReturnsLieOnTheSurfaces)
{
  auto scan = MakeDrivingScan(MakeBoxScene(Sizes), 91, 90);
  scan->SetTurnRate(30.0);
  scan->Update();
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  const std::vector<double> ids = GetValues(scan, "BeamId");
  const std::vector<double> ranges = GetValues(scan, "Range");
  double skew = 0.0;
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const int beam = static_cast<int>(ids[i]) % 91;
    const int turn = static_cast<int>(ids[i]) / 91;
    const double beta = 4.0 * turn + 30.0 * (2.0 * beam / 27000.0);
    const auto id = static_cast<vtkIdType>(i);
    const Point direction =
      Rotate(GetTuple(scan, "SensorOrientation", id), GetPaperDirection(alpha[i], beta));
    const std::vector<double> from = GetTuple(scan, "SensorPosition", id);
    const Point start = { from[0], from[1], from[2] };
    EXPECT_NEAR(ranges[i], GetRangeInBox(Sizes, start, direction), 1e-12) << i;
    Point skewed;
    scan->GetOutput()->GetPoint(id, skewed.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      skew = std::max(skew, std::abs(skewed[axis]) - Sizes[axis]);
    }
  }
  EXPECT_GT(skew, 0.05);
}

TEST(LMS3DScanMotion, AtRestChangesNoBit)
{
  auto poses = MakePoses({ { 0.1, 0.7, -0.3 }, { 0.1, 0.7, -0.3 }, { 2.0, 0.0, 0.0 } });
  AddArray(poses, "Time", 1, { 0.0, 100.0, 101.0 });
  AddArray(poses, "Orientation", 4, { 0.9, 0.1, 0.2, 0.3, 0.9, 0.1, 0.2, 0.3, 0.9, 0.1, 0.2, 0.3 });
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 61, 72);
  scan->SetTrajectoryData(poses);
  scan->Update();
  const std::uint64_t resting = HashOutputs(scan);
  scan->MotionDuringScanOn();
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), resting);
  scan->SetTrajectoryData(nullptr);
  scan->SetPosition(0.1, 0.7, -0.3);
  scan->Update();
  const std::uint64_t alone = HashOutputs(scan);
  scan->MotionDuringScanOff();
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), alone);
}

// The beams before the sensor moves are cast like all beams of a moving sensor.
TEST(LMS3DScanMotion, BeforeItStartsChangesNoBit)
{
  const double start = 0.5;
  auto poses = MakePoses({ { 0.1, 0.7, 1.0 }, { 0.1, 0.7, 1.0 }, { 0.6, 0.0, 1.0 } });
  AddArray(poses, "Time", 1, { 0.0, start, 1.0 });
  AddArray(poses, "Orientation", 4, { 0.9, 0.1, 0.2, 0.3, 0.9, 0.1, 0.2, 0.3, 0.9, 0.1, 0.2, 0.1 });
  auto scan = MakeScan(ReadRoom());
  SetGrid(scan, 61, 72);
  scan->ComputeTimeOn();
  scan->SetTrajectoryData(poses);
  scan->Update();
  const std::vector<double> resting = GetValues(scan, "Range");
  scan->MotionDuringScanOn();
  scan->Update();
  const std::vector<double> moving = GetValues(scan, "Range");
  const std::vector<double> times = GetValues(scan, "Time");
  ASSERT_EQ(moving.size(), resting.size());
  int changed = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    if (times[i] <= start)
    {
      EXPECT_EQ(moving[i], resting[i]) << i;
    }
    else
    {
      changed += moving[i] != resting[i] ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 1000);
}

TEST(LMS3DScanMotion, PointsStayThoseOfARestingSensor)
{
  auto scan = MakeDrivingScan(MakeBoxScene(Sizes), 37, 36);
  scan->Update();
  vtkFieldData* fieldData = scan->GetOutput()->GetFieldData();
  vtkDataArray* matrix = fieldData->GetArray("SensorToWorld");
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  const std::vector<double> beta = GetValues(scan, "Beta");
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Point direction = GetPaperDirection(alpha[i], beta[i]);
    Point point;
    scan->GetOutput()->GetPoint(i, point.data());
    for (int row = 0; row < 3; ++row)
    {
      double expected = matrix->GetTuple1(4 * row + 3);
      for (int column = 0; column < 3; ++column)
      {
        expected += matrix->GetTuple1(4 * row + column) * GetRange(scan, i) * direction[column];
      }
      EXPECT_NEAR(point[row], expected, 1e-12);
    }
  }
}

TEST(LMS3DScanMotion, WritesThePoseOfEachTurn)
{
  auto scan = MakeDrivingScan(MakeBoxScene(Sizes), 37, 36);
  scan->Update();
  vtkFieldData* fieldData = scan->GetOutput()->GetFieldData();
  vtkDataArray* turns = fieldData->GetArray("TurnToWorld");
  ASSERT_NE(turns, nullptr);
  ASSERT_EQ(turns->GetNumberOfComponents(), 16);
  ASSERT_EQ(turns->GetNumberOfTuples(), 36);
  for (int entry = 0; entry < 16; ++entry)
  {
    EXPECT_EQ(
      turns->GetComponent(0, entry), fieldData->GetArray("SensorToWorld")->GetTuple1(entry));
  }
  for (int turn = 0; turn < 36; ++turn)
  {
    const vtkIdType first = 37 * turn;
    const std::vector<double> position = GetTuple(scan, "SensorPosition", first);
    const std::vector<double> orientation = GetTuple(scan, "SensorOrientation", first);
    for (int row = 0; row < 3; ++row)
    {
      EXPECT_EQ(turns->GetComponent(turn, 4 * row + 3), position[row]);
      for (int column = 0; column < 3; ++column)
      {
        Point axis = { 0.0, 0.0, 0.0 };
        axis[column] = 1.0;
        EXPECT_NEAR(
          turns->GetComponent(turn, 4 * row + column), Rotate(orientation, axis)[row], 1e-15);
      }
    }
  }
  scan->MotionDuringScanOff();
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetFieldData()->GetArray("TurnToWorld"), nullptr);
}

TEST(LMS3DScanMotion, WithoutItAllPosesAreThatOfTheScan)
{
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 9, 8);
  scan->SetPosition(0.1, 0.2, 0.3);
  scan->SetOrientation(0.0, 0.0, 90.0);
  scan->ComputePosesOn();
  scan->Update();
  for (vtkIdType i = 0; i < 72; ++i)
  {
    EXPECT_EQ(GetTuple(scan, "SensorPosition", i), (std::vector<double>{ 0.1, 0.2, 0.3 }));
    const std::vector<double> q = GetTuple(scan, "SensorOrientation", i);
    EXPECT_NEAR(q[0], std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(q[3], std::sqrt(0.5), 1e-15);
  }
}
