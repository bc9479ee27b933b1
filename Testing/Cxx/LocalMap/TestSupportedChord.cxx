// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks how far returns support planes at depth steps.
 */
#include "LocalMap/Borders/lms3dSupportedChord.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
// One step at a time.
double FindEndByBisection(const lms3dSupportedChord& chord, double maximum)
{
  constexpr int Steps = 8;
  double within = 0.0;
  double beyond = maximum;
  for (int step = 0; step < Steps; ++step)
  {
    const double middle = 0.5 * (within + beyond);
    (chord.IsSupported(middle) ? within : beyond) = middle;
  }
  return within;
}

// Planes of any slope through a return or beside it, at gates of 0.1 to 30 degrees.
lms3dSupportedChord MakeRandomChord(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double range = 0.5 + 20.0 * uniform(random);
  const double margin = 0.05 * uniform(random);
  const double inverse = 1.0 / (range + 1.5 * margin * (2.0 * uniform(random) - 1.0));
  return { inverse, inverse * (2.0 * uniform(random) - 1.0),
    std::cos(0.002 + 0.5 * uniform(random)), range, margin };
}
} // namespace

TEST(SupportedChord, EndsWhereABisectionStepByStepEnds)
{
  std::mt19937 random(3);
  int inside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const lms3dSupportedChord chord = MakeRandomChord(random);
    const double maximum = 0.05 + 0.0009 * (i % 1000);
    const double end = chord.FindEnd(maximum);
    if (chord.IsSupported(maximum))
    {
      EXPECT_EQ(end, maximum);
      continue;
    }
    EXPECT_EQ(end, FindEndByBisection(chord, maximum));
    EXPECT_FALSE(chord.IsSupported(end + maximum / 256.0));
    inside += end > 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 2000);
}

// A plane that faces the sensor lies at range / cosine beside the return.
TEST(SupportedChord, GoesOnAlongPlanesThatFaceTheSensor)
{
  for (const double cosine : { 0.5, 0.9, 0.99996 })
  {
    const lms3dSupportedChord chord = { 0.25, 0.25 * (cosine - 1.0), cosine, 4.0, 0.01 };
    EXPECT_EQ(chord.FindEnd(0.9), 0.9) << cosine;
  }
}

TEST(SupportedChord, EndsAtTheMargin)
{
  // The ranges grow from 4 m to 8 m; 1 m of it is supported: at inverse ranges of 1/5 m.
  const lms3dSupportedChord chord = { 0.25, -0.125, 1.0, 4.0, 1.0 };
  const double end = chord.FindEnd(1.0);
  EXPECT_LE(end, 0.4);
  EXPECT_GT(end, 0.4 - 1.0 / 256.0);
}
