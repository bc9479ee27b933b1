// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dDeviceSettings.h"

#include "Device/lms3dScanChecks.h"
#include "Pipeline/lms3dText.h"

#include <cmath>

namespace
{
// More would not fit into memory, and would not change the result.
constexpr int MaximumSamples = 1000;

// A wider beam is no beam.
constexpr double MaximumDivergence = 1.0;

bool IsLength(double value)
{
  return value >= 0.0 && std::isfinite(value);
}
} // namespace

std::string lms3dFindDeviceError(const lms3dDeviceSettings& settings)
{
  const lms3dPlatform& platform = settings.Platform;
  const lms3dFootprint& footprint = settings.Footprint;
  const double tenPercent = settings.Reflectance.RangeAtTenPercent;
  if (!lms3dIsPosition(platform.AxisOffset))
  {
    return lms3dJoinText("AxisOffset is ", platform.AxisOffset[0], ' ', platform.AxisOffset[1], ' ',
      platform.AxisOffset[2], " m; finite numbers up to 1e18 are expected.");
  }
  if (!std::isfinite(platform.TurnRate))
  {
    return lms3dJoinText(
      "TurnRate is ", platform.TurnRate, " degrees a second; a finite number is expected.");
  }
  if (!IsLength(footprint.Diameter))
  {
    return lms3dJoinText(
      "BeamDiameter is ", footprint.Diameter, " m; a finite number from 0 on is expected.");
  }
  if (!(footprint.Divergence >= 0.0 && footprint.Divergence <= MaximumDivergence))
  {
    return lms3dJoinText("BeamDivergence is ", footprint.Divergence, "; 0 to ", MaximumDivergence,
      " metres of diameter per metre of range are expected.");
  }
  if (footprint.Samples < 1 || footprint.Samples > MaximumSamples)
  {
    return lms3dJoinText(
      "BeamSamples is ", footprint.Samples, "; 1 to ", MaximumSamples, " rays are expected.");
  }
  if (!IsLength(footprint.PulseLength))
  {
    return lms3dJoinText(
      "PulseLength is ", footprint.PulseLength, " m; a finite number from 0 on is expected.");
  }
  if (!IsLength(tenPercent))
  {
    return lms3dJoinText(
      "RangeAtTenPercent is ", tenPercent, " m; a finite number from 0 on is expected.");
  }
  return std::string();
}
