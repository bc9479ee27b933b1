// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with a trajectory: its times, its poses, and what is wrong with it.
 */
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> MakePoses(const std::vector<Point>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  auto poses = vtkSmartPointer<vtkPolyData>::New();
  poses->SetPoints(points);
  return poses;
}

void AddLine(vtkPolyData* poses, const std::vector<vtkIdType>& order)
{
  if (poses->GetNumberOfLines() == 0)
  {
    poses->SetLines(vtkNew<vtkCellArray>());
  }
  poses->GetLines()->InsertNextCell(static_cast<vtkIdType>(order.size()), order.data());
}

void AddArray(
  vtkPolyData* poses, const char* name, int components, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  poses->GetPointData()->AddArray(array);
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeJourney(vtkPolyData* poses)
{
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 9, 8);
  scan->SetTrajectoryData(poses);
  return scan;
}

std::vector<double> GetTimes(vtkLMS3DScanFilter* scan, int port = 0)
{
  scan->UpdateInformation();
  vtkInformation* info = scan->GetOutputInformation(port);
  const double* first = info->Get(Pipeline::TIME_STEPS());
  return first ? std::vector<double>(first, first + info->Length(Pipeline::TIME_STEPS()))
               : std::vector<double>();
}

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

const std::vector<Point> ThreePlaces = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 } };
} // namespace

TEST(LMS3DScanTrajectory, NumbersThePosesWithoutTimes)
{
  auto scan = MakeJourney(MakePoses(ThreePlaces));
  for (int port : { 0, 1 })
  {
    EXPECT_EQ(GetTimes(scan, port), (std::vector<double>{ 0, 1, 2 }));
    const double* range = scan->GetOutputInformation(port)->Get(Pipeline::TIME_RANGE());
    EXPECT_EQ(range[0], 0.0);
    EXPECT_EQ(range[1], 2.0);
  }
}

TEST(LMS3DScanTrajectory, GivesTheScanOfTheLastPoseWhoseTimeHasCome)
{
  auto poses = MakePoses(ThreePlaces);
  AddArray(poses, "Time", 1, { 10, 11, 15 });
  auto scan = MakeJourney(poses);
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
    EXPECT_EQ(GetPosition(scan), ThreePlaces[c.Step]);
    EXPECT_EQ(scan->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), c.Given);
    EXPECT_EQ(
      scan->GetRangeImage()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), c.Given);
  }
}

TEST(LMS3DScanTrajectory, StartsWithTheFirstPose)
{
  auto scan = MakeJourney(MakePoses({ { 0, 1, 0 }, { 0, 2, 0 } }));
  scan->SetPosition(3.0, 0.0, 0.0);
  scan->Update();
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 1, 0 }));
}

TEST(LMS3DScanTrajectory, BuildsOnceForAllSteps)
{
  auto scan = MakeJourney(MakePoses(ThreePlaces));
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
  auto scan = MakeJourney(MakePoses(ThreePlaces));
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
  auto scan = MakeJourney(MakePoses(ThreePlaces));
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
  auto poses = MakePoses(ThreePlaces);
  auto scan = MakeJourney(poses);
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
  auto newer = MakePoses(ThreePlaces);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(newer);
  auto scan = MakeJourney(nullptr);
  scan->SetTrajectoryConnection(producer->GetOutputPort());
  scan->Update();
  EXPECT_EQ(GetTimes(scan).size(), 3u);
  producer->SetOutput(older);
  scan->Update();
  EXPECT_EQ(GetTimes(scan).size(), 1u);
  EXPECT_EQ(GetPosition(scan), (Point{ 0, 0, 1 }));
}

TEST(LMS3DScanTrajectory, RefusesOtherKindsOfData)
{
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, MakePoses(ThreePlaces));
  auto scan = MakeJourney(MakePoses(ThreePlaces));
  scan->Update();
  ASSERT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  scan->SetTrajectoryData(group);
  const std::string error = UpdateAndGetError(scan);
  EXPECT_NE(error.find("The trajectory is not a vtkPolyData"), std::string::npos) << error;
  EXPECT_EQ(scan->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  for (int port : { 0, 1 })
  {
    EXPECT_EQ(scan->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }

  scan->SetTrajectoryData(MakePoses(ThreePlaces));
  scan->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DScanTrajectory, TurnsByQuaternions)
{
  const double half = std::sqrt(0.5);
  auto poses = MakePoses({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } });
  // None, 90 degrees about z, and the same again at a length that no square holds.
  AddArray(
    poses, "Orientation", 4, { 1, 0, 0, 0, half, 0, 0, half, half * 1e300, 0, 0, half * 1e300 });
  auto scan = MakeJourney(poses);
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
  auto scan = MakeJourney(poses);
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

namespace
{
struct BadTrajectory
{
  const char* Name;
  void (*Spoil)(vtkPolyData*);
  const char* Words;
};

void PrintTo(const BadTrajectory& bad, std::ostream* os)
{
  *os << bad.Name;
}

class Bad : public testing::TestWithParam<BadTrajectory>
{
};

const BadTrajectory BadTrajectories[] = {
  { "NoPoints", [](vtkPolyData* poses) { poses->Initialize(); }, "no points" },
  { "PositionIsNaN", [](vtkPolyData* poses) { poses->GetPoints()->SetPoint(1, NAN, 0, 0); },
    "point 1 at nan 0 0" },
  { "PositionIsFar", [](vtkPolyData* poses) { poses->GetPoints()->SetPoint(1, 1e19, 0, 0); },
    "point 1 at 1e+19 0 0" },
  { "TimeStands",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 1, { 0, 1, 1 });
    },
    "Time 1 at its point 2, after 1" },
  { "TimeRunsBack",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 1, { 0, -1, 1 });
    },
    "Time -1 at its point 1, after 0" },
  { "TimeIsNaN",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 1, { NAN, 1, 2 });
    },
    "Time nan at its point 0" },
  { "TimeIsInfinite",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 1, { 0, 1, Infinity });
    },
    "Time inf at its point 2" },
  { "TimeHasTwoComponents",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 2, { 0, 1, 2, 3, 4, 5 });
    },
    "Time of 2 components" },
  { "TimesAreTooFew",
    [](vtkPolyData* poses) {
      AddArray(poses, "Time", 1, { 0, 1 });
    },
    "only 2 values" },
  { "OrientationHasThreeComponents",
    [](vtkPolyData* poses) { AddArray(poses, "Orientation", 3, std::vector<double>(9, 1.0)); },
    "quaternions w x y z" },
  { "QuaternionIsZero",
    [](vtkPolyData* poses) {
      AddArray(poses, "Orientation", 4, { 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0 });
    },
    "Orientation 0 0 0 0 at its point 1" },
  { "QuaternionIsNaN",
    [](vtkPolyData* poses) {
      AddArray(poses, "Orientation", 4, { 1, 0, 0, 0, 1, NAN, 0, 0, 1, 0, 0, 0 });
    },
    "Orientation 1 nan 0 0 at its point 1" },
  { "TwoLines",
    [](vtkPolyData* poses)
    {
      AddLine(poses, { 0, 1 });
      AddLine(poses, { 1, 2 });
    },
    "2 lines" },
  { "LineOfNoPoints", [](vtkPolyData* poses) { AddLine(poses, {}); }, "no points" },
  { "LineBeyondThePoints",
    [](vtkPolyData* poses) {
      AddLine(poses, { 0, 7 });
    },
    "missing points" },
};
} // namespace

TEST_P(Bad, GivesAnErrorAndEmptyOutputs)
{
  auto poses = MakePoses(ThreePlaces);
  GetParam().Spoil(poses);
  auto scan = MakeJourney(poses);
  EXPECT_TRUE(GetTimes(scan).empty());
  const std::string error = UpdateAndGetError(scan);
  EXPECT_NE(error.find("The trajectory has"), std::string::npos) << error;
  EXPECT_NE(error.find(GetParam().Words), std::string::npos) << error;
  EXPECT_EQ(scan->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanTrajectory, Bad, testing::ValuesIn(BadTrajectories),
  [](const auto& bad) { return bad.param.Name; });
