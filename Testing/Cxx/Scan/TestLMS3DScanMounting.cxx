// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with other mountings: where the beams point, and what they measure.
 */
#include "Scan/DeviceFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace
{
const Point Sizes = { 3.0, 2.0, 1.5 };

struct Mounting
{
  int Value;
  double Beta[2];
  std::size_t Directions;
};

// Section 2 of Wulf and Wagner 2003: how many of the beams in steps of 0.5 x 1 degrees are
// different.
const Mounting AllMountings[] = { { vtkLMS3DScanFilter::YAWING, { 0.0, 359.0 }, 129242 },
  { vtkLMS3DScanFilter::YAWING_TOP, { 0.0, 179.0 }, 64801 },
  { vtkLMS3DScanFilter::PITCHING, { -90.0, 89.0 }, 64622 },
  { vtkLMS3DScanFilter::ROLLING, { 0.0, 179.0 }, 64801 } };

vtkSmartPointer<vtkLMS3DScanFilter> MakeMountedScan(const Mounting& mounting, const Point& sizes)
{
  auto scan = MakeScan(MakeBoxScene(sizes));
  scan->SetMounting(mounting.Value);
  scan->SetBetaRange(mounting.Beta[0], mounting.Beta[1]);
  scan->SetBetaResolution(static_cast<int>(mounting.Beta[1] - mounting.Beta[0]) + 1);
  return scan;
}

Point GetReturn(vtkLMS3DScanFilter* scan, vtkIdType i)
{
  Point point;
  scan->GetOutput()->GetPoint(i, point.data());
  return point;
}
} // namespace

TEST(LMS3DScanMounting, PointsWhereItsDocumentationSays)
{
  for (const Mounting& mounting : AllMountings)
  {
    SCOPED_TRACE(vtkLMS3DScanFilter::GetMountingName(mounting.Value));
    auto scan = MakeMountedScan(mounting, Sizes);
    scan->SetAlphaResolution(91);
    scan->Update();
    const std::vector<double> alpha = GetValues(scan, "Alpha");
    const std::vector<double> beta = GetValues(scan, "Beta");
    const std::vector<double> ranges = GetValues(scan, "Range");
    ASSERT_EQ(ranges.size(), 91u * scan->GetBetaResolution());
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      const Point direction = GetMountedDirection(mounting.Value, alpha[i], beta[i]);
      ASSERT_NEAR(ranges[i], GetRangeInBox(Sizes, { 0, 0, 0 }, direction), 1e-12 * ranges[i]);
      const Point point = GetReturn(scan, static_cast<vtkIdType>(i));
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_NEAR(point[axis], ranges[i] * direction[axis], 1e-12);
      }
    }
  }
}

TEST(LMS3DScanMounting, HasTheNumberOfDifferentDirections)
{
  for (const Mounting& mounting : AllMountings)
  {
    SCOPED_TRACE(vtkLMS3DScanFilter::GetMountingName(mounting.Value));
    auto scan = MakeMountedScan(mounting, Sizes);
    scan->Update();
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * scan->GetBetaResolution());
    std::set<std::array<long, 3>> directions;
    for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const Point point = GetReturn(scan, i);
      // Far from the boundaries of the cells, where exact directions lie.
      const auto toCell = [&](int axis)
      { return std::lround(1e8 * point[axis] / GetRange(scan, i) + 0.37); };
      directions.insert({ toCell(0), toCell(1), toCell(2) });
    }
    EXPECT_EQ(directions.size(), mounting.Directions);
  }
}

// Each mounting turns the same fan about another axis, so the box with turned axes gives the same
// ranges.
TEST(LMS3DScanMounting, MeasuresABoxWithPermutedAxesAlike)
{
  const auto getRanges = [](int mounting, const Point& sizes, double first, double last)
  {
    auto scan = MakeScan(MakeBoxScene(sizes));
    scan->SetMounting(mounting);
    scan->SetAlphaResolution(181);
    scan->SetBetaRange(first, last);
    scan->SetBetaResolution(181);
    scan->Update();
    std::vector<double> ranges = GetValues(scan, "Range");
    std::sort(ranges.begin(), ranges.end());
    return ranges;
  };
  const auto [x, y, z] = Sizes;
  const std::vector<double> yawing =
    getRanges(vtkLMS3DScanFilter::YAWING, { x, y, z }, -90.0, 90.0);
  const std::vector<double> pitching =
    getRanges(vtkLMS3DScanFilter::PITCHING, { x, z, y }, -90.0, 90.0);
  const std::vector<double> top =
    getRanges(vtkLMS3DScanFilter::YAWING_TOP, { x, y, z }, 0.0, 180.0);
  const std::vector<double> rolling =
    getRanges(vtkLMS3DScanFilter::ROLLING, { z, x, y }, 0.0, 180.0);
  ASSERT_EQ(yawing.size(), 181u * 181u);
  for (std::size_t i = 0; i < yawing.size(); ++i)
  {
    ASSERT_DOUBLE_EQ(pitching[i], yawing[i]);
    ASSERT_DOUBLE_EQ(rolling[i], top[i]);
  }
}

// A fan through the axis sees half of the fan above the horizon on either side.
TEST(LMS3DScanMounting, TopSeesWhatTwoHalfFansSee)
{
  auto top = MakeMountedScan(AllMountings[1], Sizes);
  top->SetAlphaResolution(181);
  top->Update();
  auto half = MakeScan(MakeBoxScene(Sizes));
  half->SetAlphaRange(0.0, 90.0);
  half->SetAlphaResolution(91);
  half->Update();
  for (int turn = 0; turn < 180; ++turn)
  {
    for (int beam = 0; beam <= 90; ++beam)
    {
      EXPECT_DOUBLE_EQ(GetRange(top, 181 * turn + 180 - beam), GetRange(half, 91 * turn + beam));
      EXPECT_DOUBLE_EQ(GetRange(top, 181 * turn + beam), GetRange(half, 91 * (turn + 180) + beam));
    }
  }
}
