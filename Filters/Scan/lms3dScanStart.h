// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where and when a scan starts, and how the sensor moves from there.
 */
#ifndef lms3dScanStart_h
#define lms3dScanStart_h

#include "Device/lms3dMotion.h"
#include "Device/lms3dScanGeometry.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dProcesses.h"

#include <cmath>
#include <memory>

struct lms3dScanStart
{
  lms3dPose Pose = {};

  /// Seconds, NaN without a trajectory.
  double Time = NAN;

  /// Null if the sensor rests during the scan.
  std::unique_ptr<const lms3dMotion> Motion;

  /// Replaces all by the first process's. Collective.
  void Broadcast(const lms3dProcesses& processes);

  /// Returns the beams of a scan that starts here. Geometry and this object must outlive them.
  lms3dMovingBeams MakeBeams(const lms3dScanGeometry& geometry) const
  {
    return { geometry, this->Pose, this->Motion.get(), std::isnan(this->Time) ? 0.0 : this->Time };
  }
};

#endif
