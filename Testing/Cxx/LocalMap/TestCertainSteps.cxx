// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which depth steps between two planes of three returns are certain.
 */
#include "LocalMap/Grid/lms3dDepthStep.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{
constexpr double DepthStep = 0.1;
/// Degrees between beams.
constexpr double Angle = 1.0;

/// Six ranges along a fan. The pair is in the middle.
using Ranges = std::array<double, 6>;

lms3dDepthStep::Relation Classify(const Ranges& ranges, double depthStep, double noise = 0.0)
{
  return lms3dDepthStep(depthStep, Angle, noise).Classify(ranges.data() + 2);
}

/// A wall at 10 m and a wall that stands behind it by a difference, metres, across the fan.
Ranges MakeWalls(double difference)
{
  Ranges ranges;
  for (int i = 0; i < 6; ++i)
  {
    const double cosine = std::cos(vtkMath::RadiansFromDegrees((i - 2.5) * Angle));
    ranges[i] = (i < 3 ? 10.0 : 10.0 + difference) / cosine;
  }
  return ranges;
}
} // namespace

TEST(CertainSteps, AreLargerThanOneAndAHalfDepthSteps)
{
  EXPECT_EQ(Classify(MakeWalls(0.14), DepthStep), lms3dDepthStep::Joined);
  EXPECT_EQ(Classify(MakeWalls(0.16), DepthStep), lms3dDepthStep::Separate);
}

// A gentle bend makes planes that miss the returns by less than 5 mm.
TEST(CertainSteps, AreLargerThanBendsForEachDepthStep)
{
  const Ranges bent = { 1.99, 1.995, 2.0, 2.003, 2.013, 2.023 };
  const Ranges apart = { 1.98, 1.99, 2.0, 2.001, 2.011, 2.021 };
  for (double depthStep : { 0.0, 1e-6 })
  {
    EXPECT_TRUE(lms3dDepthStep::IsOneSurface(Classify(bent, depthStep)));
    EXPECT_EQ(Classify(apart, depthStep), lms3dDepthStep::Separate);
  }
}

// Near the sensor, noise of inverse ranges is large. The planes meet both returns within the noise,
// which can hide the step.
TEST(CertainSteps, AreNotHiddenByNoiseNearTheSensor)
{
  const Ranges ranges = { 0.105, 0.105, 0.105, 1.22, 1.22, 1.22 };
  EXPECT_EQ(Classify(ranges, DepthStep, 0.02), lms3dDepthStep::Noisy);
  EXPECT_EQ(Classify(ranges, DepthStep, 0.005), lms3dDepthStep::Separate);
}
