// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which neighbours along one fan lie on one surface, on profiles with known results.
 */
#include "LocalMap/Grid/lms3dDepthStep.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{
constexpr double Tolerance = 0.1;

/// A straight line in the plane of the fan at a distance, metres. The beam at `Angle`, degrees,
/// hits it at a right angle.
struct Line
{
  double Distance;
  double Angle;

  double GetRange(double angle) const
  {
    const double cosine = std::cos(vtkMath::RadiansFromDegrees(angle - this->Angle));
    return cosine > 0.0 ? this->Distance / cosine : std::numeric_limits<double>::infinity();
  }
};

/// The ranges of beams in equal steps from 0 degrees on, each of the line that it hits first.
std::vector<double> Scan(const std::vector<Line>& lines, double step, int count)
{
  std::vector<double> ranges;
  for (int i = 0; i < count; ++i)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Line& line : lines)
    {
      nearest = std::min(nearest, line.GetRange(i * step));
    }
    ranges.push_back(nearest);
  }
  return ranges;
}

/// The relation of the range at an index to the next one. Beyond the ends, there are no returns.
lms3dDepthStep::Relation Classify(
  const std::vector<double>& ranges, double step, int place, double noise = 0.0)
{
  const auto get = [&](int i)
  { return i >= 0 && i < static_cast<int>(ranges.size()) ? ranges[i] : 0.0; };
  const double six[6] = { get(place - 2), get(place - 1), get(place), get(place + 1),
    get(place + 2), get(place + 3) };
  return lms3dDepthStep(Tolerance, step, noise).Classify(six + 2);
}

/// The relation of the two middle ones of six ranges along a turn at elevation 0.
lms3dDepthStep::Relation ClassifyTurn(const std::vector<double>& six, double step)
{
  return lms3dDepthStep(Tolerance, step)
    .Classify(
      lms3dDepthStep::GetSideBefore(six.data() + 2), lms3dDepthStep::GetSideBehind(six.data() + 2));
}

/// The first beam of each pair of neighbours that is not on one surface.
std::vector<int> FindSteps(const std::vector<double>& ranges, double step)
{
  std::vector<int> steps;
  for (int i = 0; i + 1 < static_cast<int>(ranges.size()); ++i)
  {
    const lms3dDepthStep::Relation relation = Classify(ranges, step, i);
    if (!lms3dDepthStep::IsOneSurface(relation))
    {
      steps.push_back(i);
    }
  }
  return steps;
}
} // namespace

TEST(DepthStep, JoinsTheCreasesOfAnyRoom)
{
  // A rectangle around the sensor, turned so that its corners come anywhere between two beams, and
  // each wall has three returns.
  for (double step : { 1.0, 4.0, 10.0 })
  {
    for (int i = 0; i < 10; ++i)
    {
      const double turn = 0.1 * i * step;
      for (double nearest : { 0.01, 0.3, 2.0 })
      {
        // More than a circle, so that each wall has three returns.
        const int count = static_cast<int>(360.0 / step) + 8;
        const std::vector<double> ranges = Scan(
          { { nearest, turn }, { 3.0, 90.0 + turn }, { 8.0, 180.0 + turn }, { 1.0, 270.0 + turn } },
          step, count);
        std::vector<int> steps = FindSteps(ranges, step);
        const auto isAtEnd = [&](int place) { return place < 2 || place > count - 5; };
        steps.erase(std::remove_if(steps.begin(), steps.end(), isAtEnd), steps.end());
        EXPECT_EQ(steps, std::vector<int>()) << step << ' ' << turn;
      }
    }
  }
}

TEST(DepthStep, DoubtsCreasesBesideTwoReturns)
{
  // The last two returns before the wall lie on a line that leads behind it. The return before them
  // does not lie on that line.
  const std::vector<double> ranges = { 1.9, 2.6, 3.5, 4.7, 4.72, 4.75 };
  EXPECT_EQ(Classify(ranges, 4.0, 2), lms3dDepthStep::Uncertain);
}

// In a fine scan, two returns do not show a wall that beams meet at 3 degrees.
TEST(DepthStep, SeparatesSteepSlopesOfTwoReturns)
{
  const std::vector<double> ranges = { 1.9, 2.6, 3.5, 4.7, 4.72, 4.75 };
  EXPECT_EQ(Classify(ranges, 1.0, 2), lms3dDepthStep::Separate);
}

// Two boxes side by side: the planes of their fronts do not meet between the last two beams, but
// nearly.
TEST(DepthStep, JoinsGapsUpToTwiceTheStepOnlyBesideALowStep)
{
  const std::vector<double> low = { 2.0, 2.0, 2.0, 2.12, 2.12, 2.12 };
  EXPECT_EQ(Classify(low, 0.5, 2), lms3dDepthStep::Joined);
  const std::vector<double> high = { 2.0, 2.0, 2.0, 2.25, 2.16, 2.08 };
  EXPECT_EQ(Classify(high, 0.5, 2), lms3dDepthStep::Separate);
}

// Hills: from the last return of the nearer side, the ground goes on less steeply than before and
// behind.
TEST(DepthStep, JoinsGentleSlopesBehindACurve)
{
  const std::vector<double> curved = { 9.0, 9.4, 10.0, 10.4, 11.1, 12.0 };
  EXPECT_EQ(Classify(curved, 1.0, 2), lms3dDepthStep::Likely);
  const std::vector<double> straight = { 8.96, 9.45, 10.0, 10.4, 11.1, 12.0 };
  EXPECT_EQ(Classify(straight, 1.0, 2), lms3dDepthStep::Separate);
  const std::vector<double> steep = { 9.0, 9.4, 10.0, 10.5, 11.4, 12.5 };
  EXPECT_EQ(Classify(steep, 1.0, 2), lms3dDepthStep::Separate);
  // Along turns, hills end in front of other hills with such slopes.
  EXPECT_EQ(ClassifyTurn(curved, 1.0), lms3dDepthStep::Separate);
}

// A round tower beside a wall, seen from 25 m: the ranges differ by less than two percent.
TEST(DepthStep, JoinsCurvesWithinTheTolerance)
{
  const std::vector<double> curved = { 24.76, 24.57, 24.65, 25.07, 24.52, 23.83 };
  EXPECT_EQ(ClassifyTurn(curved, 2.0), lms3dDepthStep::Loose);
  // The plane of a wall that ends 40 cm in front of the tower.
  const std::vector<double> straight = { 24.65, 24.635, 24.65, 25.07, 24.52, 23.83 };
  EXPECT_EQ(ClassifyTurn(straight, 2.0), lms3dDepthStep::Gentle);
  // Both planes end by more than the tolerance before they would meet.
  const std::vector<double> apart = { 26.6, 25.4, 24.65, 25.07, 24.0, 22.5 };
  EXPECT_EQ(ClassifyTurn(apart, 2.0), lms3dDepthStep::Gentle);
}

TEST(DepthStep, AllowsForNoise)
{
  const std::vector<double> ranges = { 4.5, 4.5, 4.5, 4.8, 4.8, 4.8 };
  EXPECT_EQ(Classify(ranges, 1.0, 2, 0.0), lms3dDepthStep::Separate);
  EXPECT_EQ(Classify(ranges, 1.0, 2, 0.02), lms3dDepthStep::Separate);
  EXPECT_EQ(Classify(ranges, 1.0, 2, 0.05), lms3dDepthStep::Noisy);
}

TEST(DepthStep, SeparatesAPoleFromTheWallBehind)
{
  for (int width : { 1, 2, 3 })
  {
    for (double angle : { 10.0, 45.0, -30.0 })
    {
      std::vector<double> ranges = Scan({ { 4.0, angle } }, 1.0, 20);
      for (int i = 0; i < width; ++i)
      {
        ranges[10 + i] -= 1.0;
      }
      EXPECT_EQ(FindSteps(ranges, 1.0), std::vector<int>({ 9, 9 + width }))
        << width << ' ' << angle;
    }
  }
}

TEST(DepthStep, SeparatesAPoleFromMisses)
{
  EXPECT_EQ(FindSteps({ 4.0, 4.0, 0.0, 3.0, 0.0, 4.0 }, 1.0), std::vector<int>({ 1, 2, 3, 4 }));
}

TEST(DepthStep, SeparatesWhatBeginsInFrontOfItsNeighbor)
{
  // Beams meet a floor one metre below. From beam 10 on, a table top lies 40 cm above it, so
  // returns farther than the last one of the floor lie in front of the floor's plane.
  std::vector<double> ranges;
  const Line floor = { 1.0, -85.0 };
  const Line table = { 0.6, -86.0 };
  for (int i = -20; i < 0; ++i)
  {
    ranges.push_back((i < -10 ? floor : table).GetRange(i));
  }
  EXPECT_EQ(FindSteps(ranges, 1.0), std::vector<int>({ 9 }));
}

TEST(DepthStep, JoinsAGrazingFloor)
{
  const std::vector<double> ranges = Scan({ { 1.0, -88.0 } }, 0.5, 4);
  EXPECT_GT(ranges[3] - ranges[2], 1.0);
  EXPECT_EQ(FindSteps(ranges, 0.5), std::vector<int>());
}

TEST(DepthStep, DoesNotAskWhichWayTheAnglesGo)
{
  std::vector<double> ranges = Scan({ { 3.0, 0.0 }, { 2.0, 90.0 } }, 10.0, 10);
  ranges[4] -= 1.0;
  EXPECT_EQ(FindSteps(ranges, 10.0), std::vector<int>({ 3, 4 }));
  EXPECT_EQ(FindSteps(ranges, -10.0), FindSteps(ranges, 10.0));
}

TEST(DepthStep, JoinsNothingAcrossHalfACircle)
{
  EXPECT_EQ(FindSteps({ 3.0, 3.0 }, 179.0), std::vector<int>());
  for (double step : { 180.0, 200.0, -180.0 })
  {
    EXPECT_EQ(FindSteps({ 3.0, 3.0 }, step), std::vector<int>({ 0 }));
  }
}

TEST(DepthStep, FlagsTheNeighborsThatAreNear)
{
  const std::vector<double> ranges = { 2.0, 2.05, 0.0, 2.0, 2.2, 2.1, 2.1, 0.0, 0.0, 5.0, 5.1001,
    5.0002, 4.9003, 4.9003, 4.7, 4.8, 4.9, 0.05, 0.1, 3.0 };
  const int pairs = static_cast<int>(ranges.size()) - 1;
  const lms3dDepthStep step(Tolerance, 1.0);
  std::vector<std::uint8_t> flags(pairs, 2);
  step.FlagNear(ranges.data(), ranges.data() + 1, pairs, 1, flags.data());
  for (int i = 0; i < pairs; ++i)
  {
    EXPECT_EQ(flags[i], step.AreNear(ranges[i], ranges[i + 1]) ? 3 : 2) << i;
  }
  std::vector<std::uint8_t> none(pairs, 0);
  lms3dDepthStep(Tolerance, 180.0)
    .FlagNear(ranges.data(), ranges.data() + 1, pairs, 1, none.data());
  EXPECT_EQ(std::count(none.begin(), none.end(), 0), pairs);
}
