// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which pairs the surface around decides.
 */
#include "LocalMap/Grid/lms3dDepthStep.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double DepthStep = 0.1;

/// The relation of the two middle ones of six ranges along a turn at elevation 0, metres.
lms3dDepthStep::Relation Classify(
  const std::vector<double>& six, double step, double depthStep = DepthStep)
{
  const double* const at = six.data() + 2;
  return lms3dDepthStep(depthStep, step)
    .Classify(lms3dDepthStep::GetSideBefore(at), lms3dDepthStep::GetSideBehind(at));
}
} // namespace

// Ripples at 33 m, where neighbours are 1.15 m apart. Half a metre can be a slope or a step.
TEST(LoosePairs, AreFarFromBothPlanes)
{
  const std::vector<double> ripples = { 34.0, 32.0, 33.0, 33.5, 32.5, 34.0 };
  EXPECT_EQ(Classify(ripples, 2.0), lms3dDepthStep::Loose);
  // Each plane meets the other return.
  EXPECT_EQ(Classify({ 32.0, 32.5, 33.0, 33.5, 34.0, 34.5 }, 2.0), lms3dDepthStep::Joined);
  // No larger than two depth steps.
  EXPECT_EQ(Classify({ 34.0, 32.0, 33.0, 33.19, 32.0, 34.0 }, 2.0), lms3dDepthStep::Joined);
  // Nearer, the tolerance is small.
  std::vector<double> near = ripples;
  std::transform(near.begin(), near.end(), near.begin(), [](double range) { return 0.4 * range; });
  EXPECT_EQ(Classify(near, 2.0), lms3dDepthStep::Joined);
}

// One plane ends in front of the other, at a slope that hills have.
TEST(LoosePairs, AreGentleBetweenPlanesThatDoNotIntersect)
{
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 31.0, 31.0, 31.0 }, 2.0), lms3dDepthStep::Gentle);
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 32.0, 32.0, 32.0 }, 2.0), lms3dDepthStep::Separate);
  // Coarse scans show less.
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 32.0, 32.0, 32.0 }, 4.0), lms3dDepthStep::Separate);
  // The user wants to see far smaller steps.
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 31.0, 31.0, 31.0 }, 2.0, 0.02), lms3dDepthStep::Separate);
}

// Up to a tolerance of six depth steps: in a room, the front of a shelf ends before the wall.
TEST(LoosePairs, AreNotGentleWhereBeamsAreNear)
{
  const auto classify = [](double range) {
    return Classify({ range, range - 0.05, range, range + 0.45, range + 0.4, range + 0.45 }, 2.0);
  };
  EXPECT_EQ(classify(14.0), lms3dDepthStep::Separate);
  EXPECT_EQ(classify(14.5), lms3dDepthStep::Gentle);
}

// Three returns on each side show two walls: one ends before the other.
TEST(LoosePairs, AreNotGentleBetweenPlanes)
{
  EXPECT_EQ(Classify({ 14.5, 14.5, 14.5, 14.95, 14.95, 14.95 }, 2.0), lms3dDepthStep::Separate);
  // Here, the bend of one of the sides is too large.
  EXPECT_EQ(Classify({ 14.5, 14.45, 14.5, 14.95, 14.95, 14.95 }, 2.0), lms3dDepthStep::Gentle);
}

// A wall that begins to bend: with a depth step of 0, gaps below a millimetre do not count.
TEST(LoosePairs, AreNotMadeByRounding)
{
  const auto classify = [](double bend)
  {
    std::vector<double> wall;
    for (int i = 0; i < 6; ++i)
    {
      const double past = std::max(0, i - 2);
      wall.push_back(3.0 / std::cos(vtkMath::RadiansFromDegrees(2.0 * i)) + bend * past * past);
    }
    return Classify(wall, 2.0, 0.0);
  };
  EXPECT_EQ(classify(0.0), lms3dDepthStep::Joined);
  EXPECT_EQ(classify(0.0002), lms3dDepthStep::Joined);
  EXPECT_EQ(classify(0.004), lms3dDepthStep::Loose);
}
