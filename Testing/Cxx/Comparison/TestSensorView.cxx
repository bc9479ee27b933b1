// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Checks which points the beams of each platform cover.
 */
#include "Comparison/ComparisonFixtures.h"
#include "Comparison/lms3dSensorView.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{
const Point Offsets[] = { { 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.2, 0.0 },
  { -0.15, 0.05, 0.1 } };

vtkSmartPointer<vtkLMS3DScanFilter> MakeRoomScan(int mounting, const Point& offset, double turnRate)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetOrientation(10.0, 20.0, 30.0);
  scan->SetMounting(mounting);
  scan->SetAxisOffset(offset.data());
  scan->SetTurnRate(turnRate);
  scan->SetAlphaResolution(61);
  scan->SetBetaRange(0.0, 90.0);
  scan->SetBetaResolution(31);
  scan->Update();
  return scan;
}

// Whether a beam of the view starts and ends as the return's beam did.
bool FindsReturn(const lms3dSensorView& view, const lms3dVector& point, double range)
{
  for (int way = 0; way < view.GetNumberOfWays(); ++way)
  {
    const lms3dVector beam = lms3dSubtract(point, view.GetStart(point, way));
    if (view.Covers(point, way) && std::abs(view.GetRange(point, way) - range) < 1e-9 &&
      std::abs(lms3dGetLength(beam) - range) < 1e-9)
    {
      return true;
    }
  }
  return false;
}

// The turn and the beam of the return are not the first or the last.
bool IsInside(int beamId)
{
  return beamId % 61 > 0 && beamId % 61 < 60 && beamId / 61 > 0 && beamId / 61 < 30;
}

class EachMounting : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(EachMounting, CoversEachReturn)
{
  for (const Point& offset : Offsets)
  {
    for (double turnRate : { 0.0, 30.0, -30.0 })
    {
      const auto scan = MakeRoomScan(GetParam(), offset, turnRate);
      const lms3dSensorView view(scan->GetOutput()->GetFieldData(), { 0.0, 80.0 });
      int missed = 0;
      for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
      {
        lms3dVector point;
        scan->GetOutput()->GetPoint(i, point.data());
        const int beamId = static_cast<int>(GetArray(scan, "BeamId")->GetTuple1(i));
        missed += IsInside(beamId) && !FindsReturn(view, point, GetRange(scan, i)) ? 1 : 0;
      }
      EXPECT_EQ(missed, 0) << offset[0] << ' ' << offset[1] << ' ' << turnRate;
    }
  }
}

// The visible part of a sphere around the sensor. Half a circle of beta measures a half space.
TEST_P(EachMounting, SeesTheShareOfABallThatItsAnglesCover)
{
  auto ball = MakeBall(2.0, 96);
  const bool isAlongAxis =
    GetParam() == vtkLMS3DScanFilter::YAWING_TOP || GetParam() == vtkLMS3DScanFilter::ROLLING;
  for (double extent : { 180.0, 90.0 })
  {
    auto pose = MakePose({ 0.0, 0.0, 0.0 }, { -90.0, 0.0, 90.0 }, { 0.0, 0.5 * extent, extent });
    AddDoubles(pose, "Mounting", { static_cast<double>(GetParam()) });
    Comparison comparison(ball, ball, pose);
    const double area = comparison.Update()->GetMapArea();
    const double share = comparison.Filter->GetVisibleArea() / area;
    EXPECT_NEAR(share, extent / 360.0, 0.01) << isAlongAxis;
  }
}

// An offset moves the starts of beams: a wall beside the sensor hides other points.
TEST_P(EachMounting, LooksFromTheMirror)
{
  auto pose = MakePose({ 0.0, 0.0, 0.0 });
  AddDoubles(pose, "Mounting", { static_cast<double>(GetParam()) });
  AddDoubles(pose, "AxisOffset", { 0.1, 0.2, -0.1 });
  const lms3dSensorView view(pose->GetFieldData(), { 0.0, 80.0 });
  for (const lms3dVector& point :
    { lms3dVector{ 1.0, 2.0, 3.0 }, lms3dVector{ -2.0, 0.5, -1.0 }, lms3dVector{ 0.4, 3.0, 0.2 } })
  {
    for (int way = 0; way < 2; ++way)
    {
      EXPECT_NEAR(lms3dGetLength(view.GetStart(point, way)), std::sqrt(0.06), 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SensorView, EachMounting, testing::Range(0, 4),
  [](const auto& mounting)
  { return std::string(vtkLMS3DScanFilter::GetMountingName(mounting.param)); });
