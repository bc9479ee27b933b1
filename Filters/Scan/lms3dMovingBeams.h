// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the beams of a sensor start and point, in world coordinates, while it may move.
 */
#ifndef lms3dMovingBeams_h
#define lms3dMovingBeams_h

#include "Device/lms3dBeams.h"
#include "Device/lms3dMotion.h"
#include "Device/lms3dScanGeometry.h"
#include "Device/lms3dTurnFrame.h"
#include "Geometry/lms3dVector.h"

/// Without motion, the beams equal the ones of lms3dBeams.
class lms3dMovingBeams
{
public:
  /// `motion` is null if the sensor rests at `pose`; otherwise each beam leaves from the pose at
  /// its own time, `startTime` (seconds) plus the time since the scan's first beam. Geometry and
  /// motion must outlive the object.
  lms3dMovingBeams(const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dMotion* motion = nullptr, double startTime = 0.0);

  const lms3dScanGeometry& GetGeometry() const { return this->Geometry; }

  /// The beams in the frame of their turn.
  const lms3dFan& GetFan() const { return this->Resting.GetFan(); }

  bool IsMoving() const { return this->Motion != nullptr; }

  /// The sensor's position at the start of the scan, metres.
  const lms3dVector& GetPosition() const { return this->Pose.Position; }

  /// Returns when a beam leaves, seconds.
  double GetTime(int turn, int beam) const;

  /// Returns the sensor's pose when a beam leaves.
  lms3dPose GetPose(int turn, int beam) const;

  /// Returns the frame of a turn, of a sensor at GetPose.
  lms3dTurnFrame GetFrame(int turn, int beam) const;

  lms3dVector GetOrigin(int turn, int beam) const;

  lms3dVector GetDirection(int turn, int beam) const;

private:
  const lms3dScanGeometry& Geometry;
  const lms3dPose Pose;
  const lms3dMotion* const Motion;
  const double StartTime;
  const double FanPeriod;
  const lms3dBeams Resting;
};

#endif
