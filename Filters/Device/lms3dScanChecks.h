// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Validates pose, angles and range limits of a scan.
 *
 * The functions return a text for the user, with the bad values, or an empty string if all is good.
 */
#ifndef lms3dScanChecks_h
#define lms3dScanChecks_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

#include <string>

/// Returns whether a sensor can be at this position: finite, each coordinate up to 1e18 m.
bool lms3dIsPosition(const lms3dVector& position);

/// Checks a position (metres) and an orientation (degrees about x, y and z).
std::string lms3dFindPoseError(const lms3dVector& position, const lms3dVector& orientation);

/// Checks that the axes of the SensorToWorld of a scan are orthonormal within 1e-6, and no mirror
/// image.
std::string lms3dFindAxesError(const lms3dPose& pose);

/// Checks both ranges (degrees) and resolutions, and the number of beams.
std::string lms3dFindAngleError(
  const double alphaRange[2], int alphaResolution, const double betaRange[2], int betaResolution);

/// Checks the limits of ranges (metres).
std::string lms3dFindLimitError(const lms3dRangeLimits& limits);

#endif
