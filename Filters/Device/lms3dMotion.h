// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How a sensor moves during one scan.
 */
#ifndef lms3dMotion_h
#define lms3dMotion_h

#include "Device/lms3dPoseInterpolation.h"
#include "Device/lms3dScanGeometry.h"

#include <vector>

class lms3dTrajectory;

struct lms3dTimedPose
{
  /// Seconds.
  double Time;

  lms3dPose Pose;
};

/// The part of a trajectory between two times.
class lms3dMotion
{
public:
  /// `first` must not be later than `last`.
  lms3dMotion(const lms3dTrajectory& trajectory, double first, double last);

  /// There must be at least one pose. Times must increase.
  explicit lms3dMotion(std::vector<lms3dTimedPose> poses);

  const std::vector<lms3dTimedPose>& GetPoses() const { return this->Poses; }

  /// Returns whether the pose is the same at all times.
  bool IsAtRest() const;

  /// Returns what lms3dTrajectory::Interpolate returns, to the bit, for the times of this part.
  lms3dPose GetPose(double time) const;

private:
  std::vector<lms3dTimedPose> Poses;

  /// From each pose to the next.
  std::vector<lms3dPoseSegment> Segments;
};

#endif
