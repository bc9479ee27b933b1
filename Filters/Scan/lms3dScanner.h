// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts all beams of a scan.
 */
#ifndef lms3dScanner_h
#define lms3dScanner_h

#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>

/// What the caster chose for each beam, whatever becomes of it when it is measured: the range that
/// it chose by (lms3dBeamPacket::NoRange where there is nothing) and the triangle.
struct lms3dChoices
{
  double* Ranges;
  std::int32_t* Triangles;
};

/**
 * Fills `ranges` (metres, NaN where there is no return) and `triangles`
 * (lms3dBeamPacket::NoTriangle there), both ordered by turn, then beam. A beam whose nearest
 * surface lies outside the limits gives no return. Uses the threads of the calling TBB arena; the
 * result does not depend on their number. Returns false where `progress` stopped it.
 * `choices`, in the same order, may be null.
 */
bool lms3dScan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dBeamDirections& directions, const lms3dPose& pose, const lms3dRangeLimits& limits,
  const lms3dProgress& progress, double* ranges, std::int32_t* triangles,
  const lms3dChoices* choices = nullptr);

#endif
