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
#include "Scan/lms3dScanSettings.h"

#include <cmath>
#include <memory>

class vtkDataObject;

struct lms3dScanStart
{
  lms3dPose Pose = {};

  /// Seconds, NaN without a trajectory.
  double Time = NAN;

  /// Null if the sensor rests during the scan.
  std::unique_ptr<const lms3dMotion> Motion;

  /// Replaces all by the first process's. Collective.
  void Broadcast(const lms3dProcesses& processes);

  /// Sets DATA_TIME_STEP of an output if there is a trajectory.
  void SetDataTime(vtkDataObject* output) const;

  /// Returns whether all beams start at the sensor's position, have no width, and a fan does not
  /// move.
  bool HasPlainBeams(const lms3dDeviceSettings& device) const;

  /// Returns whether the scan has the poses of its turns.
  bool HasTurnPoses(const lms3dDeviceSettings& device) const
  {
    return device.MotionDuringScan && !std::isnan(this->Time);
  }

  /// Returns the beams of a scan that starts here; null if nothing in the settings needs them, as
  /// by default. Geometry and this object must outlive them.
  std::unique_ptr<const lms3dMovingBeams> MakeBeams(
    const lms3dScanSettings& settings, const lms3dScanGeometry& geometry) const;
};

#endif
