// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The properties of a scan, as vtkLMS3DScanFilter documents them.
 */
#ifndef lms3dScanSettings_h
#define lms3dScanSettings_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"
#include "Scan/lms3dDeviceSettings.h"

#include <array>
#include <string>

/// Metres and degrees, in world coordinates. Any values; lms3dFindSettingsError checks them.
struct lms3dScanSettings
{
  lms3dVector Position;
  lms3dVector Orientation;
  std::array<double, 2> AlphaRange;
  int AlphaResolution;
  std::array<double, 2> BetaRange;
  int BetaResolution;
  lms3dRangeLimits Limits;

  /// One of lms3dRayCaster::Method.
  int Method;

  /// 0 stands for all cores.
  int NumberOfThreads;

  /// Whether the scan says what each return has hit.
  bool SurfaceAttributes;

  lms3dDeviceSettings Device;
};

/// Returns a text for the user about the first bad property, empty if all are good.
std::string lms3dFindSettingsError(const lms3dScanSettings& settings);

#endif
