// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts all beams of a scan whose beams start at one point and form a product of turns and
 * elevations.
 */
#ifndef lms3dScanner_h
#define lms3dScanner_h

#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dProgress.h"
#include "Scan/lms3dPacketGrid.h"
#include "Scan/lms3dScanPlan.h"

/// What to scan, and where the results go. All references and arrays must outlive the scan.
struct lms3dScanRequest
{
  const lms3dRayCaster& Caster;
  const lms3dScanGeometry& Geometry;

  /// Where the sensor stands, in world coordinates, metres.
  const lms3dPose& Pose;

  /// A beam whose nearest surface is nearer than the minimum or beyond the maximum gives no return.
  lms3dRangeLimits Limits;

  /// The results; ranges are NaN where there is no return.
  lms3dBeamHits Returns;

  /// Optional: the hits that the caster found before it refined their ranges and before the minimum
  /// range removed any; ranges are lms3dBeamPacket::NoRange where there is no hit. Processes with
  /// parts of a scene compare these.
  lms3dBeamHits NearestHits = { nullptr, nullptr };

  /// Optional: a plan that fits caster, geometry, pose and maximum range. Without it, the scan
  /// makes one.
  const lms3dScanPlan* Plan = nullptr;
};

/**
 * Casts all beams of a scan. The platform must be centred and stepped (lms3dPlatform.h). Uses the
 * threads of the calling TBB arena; the results do not depend on their number. Returns false if
 * `progress`, which must not be empty, stopped the scan; the results are then undefined.
 */
bool lms3dScan(const lms3dScanRequest& request, const lms3dProgress& progress);

#endif
