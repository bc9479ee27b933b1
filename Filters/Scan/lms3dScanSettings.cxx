// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanSettings.h"

#include "Device/lms3dScanChecks.h"

std::string lms3dFindSettingsError(const lms3dScanSettings& settings)
{
  std::string error = lms3dFindPoseError(settings.Position, settings.Orientation);
  if (error.empty())
  {
    error = lms3dFindAngleError(settings.AlphaRange.data(), settings.AlphaResolution,
      settings.BetaRange.data(), settings.BetaResolution);
  }
  if (error.empty())
  {
    error = lms3dFindLimitError(settings.Limits);
  }
  return error.empty() ? lms3dFindDeviceError(settings.Device) : error;
}
