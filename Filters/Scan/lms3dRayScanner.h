// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts the beams of a scan, or several rays for each of them, wherever they start and
 * point.
 */
#ifndef lms3dRayScanner_h
#define lms3dRayScanner_h

#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dProgress.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dPacketGrid.h"
#include "Scan/lms3dRayFan.h"

#include <vector>

/// What to cast, and where the results go. All references and arrays must outlive the scan.
struct lms3dRayScanRequest
{
  const lms3dRayCaster& Caster;
  const lms3dMovingBeams& Beams;

  /// One for each ray of a beam.
  const std::vector<lms3dRayFan>& Fans;

  /// A ray whose nearest surface is nearer than the minimum or beyond the maximum gives no return.
  lms3dRangeLimits Limits;

  ///@{
  /// The turns of the scan that are to be cast.
  int FirstTurn;
  int Turns;
  ///@}

  /// The same as in lms3dScanRequest, for these turns alone: first all beams with the first ray,
  /// then all with the second, and so on. Ranges are along the rays.
  lms3dBeamHits Returns;
  lms3dBeamHits NearestHits = { nullptr, nullptr };

  /// Whether ranges have all digits. Otherwise rays with a start of their own have about 13, which
  /// takes less time.
  bool HasAllDigits = true;
};

/// Does what lms3dScan does.
bool lms3dScanRays(const lms3dRayScanRequest& request, const lms3dProgress& progress);

#endif
