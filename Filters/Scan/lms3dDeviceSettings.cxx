// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dDeviceSettings.h"

#include "Device/lms3dScanChecks.h"

#include <cmath>
#include <sstream>

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
  std::ostringstream error;
  const lms3dPlatform& platform = settings.Platform;
  const lms3dFootprint& footprint = settings.Footprint;
  const double tenPercent = settings.Reflectance.RangeAtTenPercent;
  if (!lms3dIsPosition(platform.AxisOffset))
  {
    error << "AxisOffset is " << platform.AxisOffset[0] << ' ' << platform.AxisOffset[1] << ' '
          << platform.AxisOffset[2] << " m; finite numbers up to 1e18 are expected.";
  }
  else if (!std::isfinite(platform.TurnRate))
  {
    error << "TurnRate is " << platform.TurnRate
          << " degrees a second; a finite number is expected.";
  }
  else if (!IsLength(footprint.Diameter))
  {
    error << "BeamDiameter is " << footprint.Diameter
          << " m; a finite number from 0 on is expected.";
  }
  else if (!(footprint.Divergence >= 0.0 && footprint.Divergence <= MaximumDivergence))
  {
    error << "BeamDivergence is " << footprint.Divergence << "; 0 to " << MaximumDivergence
          << " metres of diameter per metre of range are expected.";
  }
  else if (footprint.Samples < 1 || footprint.Samples > MaximumSamples)
  {
    error << "BeamSamples is " << footprint.Samples << "; 1 to " << MaximumSamples
          << " rays are expected.";
  }
  else if (!IsLength(footprint.PulseLength))
  {
    error << "PulseLength is " << footprint.PulseLength
          << " m; a finite number from 0 on is expected.";
  }
  else if (!IsLength(tenPercent))
  {
    error << "RangeAtTenPercent is " << tenPercent << " m; a finite number from 0 on is expected.";
  }
  return error.str();
}
