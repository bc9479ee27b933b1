// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter refuses bad trajectories.
 */
#include "Scan/TrajectoryFixtures.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

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
  auto poses = MakePoses(ThreePositions);
  GetParam().Spoil(poses);
  auto scan = MakeScanAlong(poses);
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

TEST(LMS3DScanTrajectory, RefusesOtherKindsOfData)
{
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, MakePoses(ThreePositions));
  auto scan = MakeScanAlong(MakePoses(ThreePositions));
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

  scan->SetTrajectoryData(MakePoses(ThreePositions));
  scan->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
}
