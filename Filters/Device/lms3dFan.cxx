// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dFan.h"

#include "Device/lms3dScanGeometry.h"

#include <cmath>

namespace
{
// The largest deviation of 1 / step from a whole number that is attributed to rounding.
constexpr double StepTolerance = 1e-6;

// Turns a vector of the frame at angle 0 to the frame that the platform has reached, and returns
// its components in the frame at angle 0.
lms3dVector Turn(const lms3dVector& v, double sine, double cosine)
{
  return { cosine * v[0] + sine * v[1], cosine * v[1] - sine * v[0], v[2] };
}
} // namespace

int lms3dCountMirrorTurns(const lms3dScanGeometry& geometry)
{
  const double step = std::abs(geometry.GetAlphaStep());
  if (step == 0.0 || step > 1.0)
  {
    return 1;
  }
  const double turns = std::round(1.0 / step);
  return std::abs(turns * step - 1.0) <= StepTolerance ? static_cast<int>(turns) : 1;
}

double lms3dGetFanPeriod(const lms3dScanGeometry& geometry)
{
  return lms3dCountMirrorTurns(geometry) / lms3dMirrorRate;
}

lms3dFan::lms3dFan(const lms3dScanGeometry& geometry)
{
  constexpr double DegreesPerSecond = 360.0 * lms3dMirrorRate;
  const int beams = geometry.GetNumberOfBeams();
  const int turns = lms3dCountMirrorTurns(geometry);
  const double measuredStep = turns * std::abs(geometry.GetAlphaStep());
  const lms3dPlatform& platform = geometry.GetPlatform();
  const lms3dVector offset = lms3dToPlatformAxes(platform.Mounting, platform.AxisOffset);
  double sine = 0.0;
  double cosine = 1.0;
  for (int beam = 0; beam < beams; ++beam)
  {
    const int mirrorTurn = beam % turns;
    const int step = beam / turns;
    const double time = mirrorTurn / lms3dMirrorRate + step * measuredStep / DegreesPerSecond;
    const double angle = platform.TurnRate * time;
    // All angles are equal while the platform stands.
    if (beam == 0 || angle != this->TurnedAngles.back())
    {
      lms3dSinCosDegrees(angle, sine, cosine);
    }
    const lms3dVector direction = { geometry.GetAlphaCosine(beam), 0.0,
      geometry.GetAlphaSine(beam) };
    this->Times.push_back(time);
    this->Directions.push_back(Turn(direction, sine, cosine));
    this->Origins.push_back(Turn(offset, sine, cosine));
    this->TurnedAngles.push_back(angle);
    this->TurnedSines.push_back(sine);
    this->TurnedCosines.push_back(cosine);
  }
}
