// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dRayFan.h"

#include "Device/lms3dScanGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
constexpr double FullCircle = 360.0;

// Measured: of several turns of the rings, this one has the smallest errors at straight edges in
// the fan's plane and across it.
constexpr double TurnPerRing = 1.0 / 3.0;

void AddRing(int ring, int points, int count, std::vector<lms3dDiscPoint>& disc)
{
  const double inside = static_cast<double>(disc.size());
  const double radius = std::sqrt((inside + (inside + points)) / (2.0 * count));
  const double turn = std::fmod(ring * TurnPerRing, 1.0);
  for (int i = 0; i < points; ++i)
  {
    double sine, cosine;
    lms3dSinCosDegrees(FullCircle * (i + turn) / points, sine, cosine);
    disc.push_back({ radius * cosine, radius * sine });
  }
}
} // namespace

std::vector<lms3dDiscPoint> lms3dGetDiscPoints(int count)
{
  std::vector<lms3dDiscPoint> disc = { { 0.0, 0.0 } };
  for (int ring = 1; static_cast<int>(disc.size()) < count; ++ring)
  {
    AddRing(ring, std::min(6 * ring, count - static_cast<int>(disc.size())), count, disc);
  }
  return disc;
}

lms3dRayFan::lms3dRayFan(const lms3dFan& fan)
  : Origins(fan.Origins)
  , Directions(fan.Directions)
{
}

lms3dRayFan::lms3dRayFan(const lms3dScanGeometry& geometry, const lms3dFan& fan,
  const lms3dFootprint& footprint, const lms3dDiscPoint& point)
  : lms3dRayFan(fan)
{
  const double offset = 0.5 * footprint.Diameter;
  const double slope = 0.5 * footprint.Divergence;
  const double length = std::sqrt(1.0 + slope * slope * (point.U * point.U + point.V * point.V));
  this->Cosine = 1.0 / length;
  for (std::size_t beam = 0; beam < fan.Times.size(); ++beam)
  {
    const double sine = fan.TurnedSines[beam];
    const double cosine = fan.TurnedCosines[beam];
    const double fanSine = geometry.GetAlphaSine(static_cast<int>(beam));
    const lms3dVector inPlane = { -cosine * fanSine, sine * fanSine,
      geometry.GetAlphaCosine(static_cast<int>(beam)) };
    const lms3dVector across = { sine, cosine, 0.0 };
    const lms3dVector aside = lms3dAdd(lms3dScale(inPlane, point.U), lms3dScale(across, point.V));
    this->Origins[beam] = lms3dAdd(fan.Origins[beam], lms3dScale(aside, offset));
    this->Directions[beam] =
      lms3dScale(lms3dAdd(fan.Directions[beam], lms3dScale(aside, slope)), 1.0 / length);
  }
}
