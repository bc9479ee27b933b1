// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with a mirror off the axis, and with a platform that turns during a
 * fan.
 */
#include "Scan/DeviceFixtures.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
// When a beam of a fan in steps of half a degree leaves, seconds.
double GetTimeInFan(int beam)
{
  const int wholeDegrees = beam / 2;
  return beam % 2 / 75.0 + wholeDegrees / 27000.0;
}

// How far a sphere of this radius is from a point `offset` before its centre, in the fan's plane.
double GetRangeInSphere(double radius, double offset, double alpha)
{
  const double a = vtkMath::RadiansFromDegrees(alpha);
  const double across = offset * std::sin(a);
  return -offset * std::cos(a) + std::sqrt(radius * radius - across * across);
}
} // namespace

TEST(LMS3DScanPlatform, OffsetFollowsTheLawOfASphere)
{
  auto ball = MakeBall(2.0, 96);
  const double inradius = GetInradius(ball);
  const double offset = 0.15;
  auto scan = MakeScan(ball);
  SetGrid(scan, 91, 72);
  scan->SetAxisOffset(offset, 0.0, 0.0);
  scan->Update();
  const std::vector<double> ranges = GetValues(scan, "Range");
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  ASSERT_EQ(ranges.size(), 91u * 72u);
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    EXPECT_GE(ranges[i], GetRangeInSphere(inradius, offset, alpha[i]) - 1e-12);
    EXPECT_LE(ranges[i], GetRangeInSphere(2.0, offset, alpha[i]) + 1e-12);
  }
}

TEST(LMS3DScanPlatform, OffsetTurnsWithThePlatform)
{
  const Point sizes = { 3.0, 2.0, 1.5 };
  const Point offset = { 0.2, 0.05, -0.1 };
  auto scan = MakeScan(MakeBoxScene(sizes));
  SetGrid(scan, 61, 72);
  scan->SetAxisOffset(offset.data());
  scan->Update();
  const std::vector<double> ranges = GetValues(scan, "Range");
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  const std::vector<double> beta = GetValues(scan, "Beta");
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const double b = vtkMath::RadiansFromDegrees(beta[i]);
    const Point start = { offset[0] * std::cos(b) + offset[1] * std::sin(b),
      offset[1] * std::cos(b) - offset[0] * std::sin(b), offset[2] };
    const Point direction = GetPaperDirection(alpha[i], beta[i]);
    ASSERT_NEAR(ranges[i], GetRangeInBox(sizes, start, direction), 1e-12);
    Point point;
    scan->GetOutput()->GetPoint(static_cast<vtkIdType>(i), point.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(point[axis], start[axis] + ranges[i] * direction[axis], 1e-12);
    }
  }
}

TEST(LMS3DScanPlatform, TurnsWhileTheMirrorSweeps)
{
  const double rate = 37.5;
  const Point sizes = { 3.0, 2.0, 1.5 };
  auto scan = MakeScan(MakeBoxScene(sizes));
  scan->SetBetaRange(10.0, 19.0);
  scan->SetBetaResolution(10);
  scan->SetTurnRate(rate);
  scan->Update();
  const std::vector<double> ranges = GetValues(scan, "Range");
  const std::vector<double> beta = GetValues(scan, "Beta");
  ASSERT_EQ(ranges.size(), 3610u);
  for (int i = 0; i < 3610; ++i)
  {
    const int beam = i % 361;
    const int turn = i / 361;
    const double angle = 10.0 + turn + rate * GetTimeInFan(beam);
    EXPECT_EQ(beta[i], static_cast<float>(angle)) << i;
    const Point direction = GetPaperDirection(-90.0 + 0.5 * beam, angle);
    EXPECT_NEAR(ranges[i], GetRangeInBox(sizes, { 0, 0, 0 }, direction), 1e-12) << i;
  }
}

// Half degrees are measured a turn of the mirror later, so a wall's edge is a comb.
TEST(LMS3DScanPlatform, NeighboursDifferByTheAngleOfAMirrorTurn)
{
  const double rate = 75.0;
  auto scan = MakeScan(MakeBoxScene({ 3.0, 2.0, 1.5 }));
  scan->SetBetaRange(0.0, 9.0);
  scan->SetBetaResolution(10);
  scan->SetTurnRate(rate);
  scan->Update();
  const std::vector<double> beta = GetValues(scan, "Beta");
  for (int beam = 0; beam < 360; beam += 2)
  {
    EXPECT_NEAR(beta[beam + 1] - beta[beam], rate / 75.0, 1e-6);
    EXPECT_NEAR(beta[beam + 2] - beta[beam], rate / 27000.0, 1e-6);
  }
  // The axis of the grid stays nominal.
  vtkDataArray* angles = scan->GetOutput()->GetFieldData()->GetArray("BetaAngles");
  EXPECT_EQ(angles->GetTuple1(3), 3.0);
}

TEST(LMS3DScanPlatform, OffsetAndRateAreThoseOfAPlatformThatStopsThere)
{
  auto room = ReadRoom();
  auto scan = MakeScan(room);
  SetGrid(scan, 37, 12);
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetOrientation(3.0, -5.0, 20.0);
  scan->SetMountingToRolling();
  scan->SetAxisOffset(0.1, 0.05, -0.02);
  scan->SetTurnRate(90.0);
  scan->Update();
  const std::vector<double> alpha = GetValues(scan, "Alpha");
  const std::vector<double> ids = GetValues(scan, "BeamId");
  auto single = MakeScan(room);
  SetGrid(single, 1, 1);
  single->SetPosition(0.3, -0.2, 1.0);
  single->SetOrientation(3.0, -5.0, 20.0);
  single->SetMountingToRolling();
  single->SetAxisOffset(0.1, 0.05, -0.02);
  for (std::size_t i = 0; i < ids.size(); i += 7)
  {
    const int beam = static_cast<int>(ids[i]) % 37;
    const int turn = static_cast<int>(ids[i]) / 37;
    // Steps of five degrees are measured in one turn of the mirror.
    const double beta = 30.0 * turn + 90.0 * (5.0 * beam / 27000.0);
    single->SetAlphaRange(alpha[i], alpha[i]);
    single->SetBetaRange(beta, beta);
    single->Update();
    ASSERT_EQ(single->GetOutput()->GetNumberOfPoints(), 1);
    EXPECT_NEAR(GetRange(single, 0), GetRange(scan, static_cast<vtkIdType>(i)), 1e-12);
  }
}
