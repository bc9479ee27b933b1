// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief When the beams of a fan leave, and where the platform is then.
 */
#include "Device/lms3dFan.h"
#include "Device/lms3dScanGeometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
lms3dScanGeometry MakeGeometry(
  double first, double last, int beams, const lms3dPlatform& platform = {})
{
  const double alpha[2] = { first, last };
  const double beta[2] = { 0.0, 360.0 };
  return { alpha, beams, beta, 360, platform };
}
} // namespace

TEST(Fan, TakesOneTurnOfTheMirrorInWholeDegrees)
{
  const lms3dScanGeometry geometry = MakeGeometry(-90.0, 90.0, 181);
  const lms3dFan fan(geometry);
  EXPECT_EQ(lms3dCountMirrorTurns(geometry), 1);
  EXPECT_EQ(lms3dGetFanPeriod(geometry), 1.0 / 75.0);
  EXPECT_EQ(fan.Times.front(), 0.0);
  EXPECT_NEAR(fan.Times.back(), 0.5 / 75.0, 1e-15);
  for (int beam = 1; beam < 181; ++beam)
  {
    EXPECT_NEAR(fan.Times[beam] - fan.Times[beam - 1], 1.0 / 27000.0, 1e-15) << beam;
  }
}

TEST(Fan, InterlacesHalfDegrees)
{
  const lms3dScanGeometry geometry = MakeGeometry(-90.0, 90.0, 361);
  const lms3dFan fan(geometry);
  EXPECT_EQ(lms3dCountMirrorTurns(geometry), 2);
  EXPECT_EQ(lms3dGetFanPeriod(geometry), 2.0 / 75.0);
  for (int beam = 0; beam < 361; ++beam)
  {
    const int wholeDegrees = beam / 2;
    const double whole = wholeDegrees / 27000.0;
    EXPECT_NEAR(fan.Times[beam], whole + (beam % 2 == 0 ? 0.0 : 1.0 / 75.0), 1e-15) << beam;
  }
}

TEST(Fan, InterlacesQuarterDegreesInFourTurns)
{
  const lms3dScanGeometry geometry = MakeGeometry(-50.0, 50.0, 401);
  const lms3dFan fan(geometry);
  EXPECT_EQ(lms3dCountMirrorTurns(geometry), 4);
  EXPECT_NEAR(lms3dGetFanPeriod(geometry), 0.05333, 1e-5);
  for (int beam = 4; beam < 401; ++beam)
  {
    EXPECT_NEAR(fan.Times[beam] - fan.Times[beam - 4], 1.0 / 27000.0, 1e-15) << beam;
  }
  for (int turn = 1; turn < 4; ++turn)
  {
    EXPECT_NEAR(fan.Times[turn], turn / 75.0, 1e-15);
  }
}

TEST(Fan, MeasuresOtherStepsInOneTurnOfTheMirror)
{
  for (int beams : { 1, 2, 37, 271 })
  {
    const lms3dScanGeometry geometry = MakeGeometry(-90.0, 90.0, beams);
    const lms3dFan fan(geometry);
    EXPECT_EQ(lms3dCountMirrorTurns(geometry), 1) << beams;
    EXPECT_NEAR(fan.Times.back(), beams > 1 ? 0.5 / 75.0 : 0.0, 1e-15) << beams;
  }
}

TEST(Fan, TurnsWithThePlatform)
{
  const lms3dPlatform platform = { lms3dMounting::Yawing, { 0.1, 0.02, 0.3 }, 37.5 };
  const lms3dScanGeometry geometry = MakeGeometry(-90.0, 90.0, 361, platform);
  const lms3dFan fan(geometry);
  for (int beam = 0; beam < 361; ++beam)
  {
    const double angle = 37.5 * fan.Times[beam];
    EXPECT_EQ(fan.TurnedAngles[beam], angle);
    const double turned = angle * std::acos(-1.0) / 180.0;
    const double cosine = std::cos(turned);
    const double sine = std::sin(turned);
    // Clockwise, seen from above.
    EXPECT_NEAR(fan.Origins[beam][0], 0.1 * cosine + 0.02 * sine, 1e-15);
    EXPECT_NEAR(fan.Origins[beam][1], 0.02 * cosine - 0.1 * sine, 1e-15);
    EXPECT_EQ(fan.Origins[beam][2], 0.3);
    const double level = geometry.GetAlphaCosine(beam);
    EXPECT_NEAR(fan.Directions[beam][0], level * cosine, 1e-15);
    EXPECT_NEAR(fan.Directions[beam][1], -level * sine, 1e-15);
    EXPECT_EQ(fan.Directions[beam][2], geometry.GetAlphaSine(beam));
  }
}
