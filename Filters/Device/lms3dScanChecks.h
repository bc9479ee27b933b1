// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Words for the user on properties of the scan that cannot be; empty where they are good.
 */
#ifndef lms3dScanChecks_h
#define lms3dScanChecks_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

#include <string>

/// Whether a sensor can be there: finite, up to 1e18 m.
bool lms3dIsPosition(const lms3dVector& position);

std::string lms3dFindPoseError(const lms3dVector& position, const lms3dVector& orientation);

std::string lms3dFindAngleError(
  const double alphaRange[2], int alphaResolution, const double betaRange[2], int betaResolution);

std::string lms3dFindLimitError(const lms3dRangeLimits& limits);

#endif
