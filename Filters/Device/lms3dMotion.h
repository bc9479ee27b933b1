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

/// The part of a trajectory between two times.
class lms3dMotion
{
public:
  /// `first` must not be later than `last`.
  lms3dMotion(const lms3dTrajectory& trajectory, double first, double last);

  /// Reads what ToNumbers returned, in another process.
  explicit lms3dMotion(const std::vector<double>& numbers);
  std::vector<double> ToNumbers() const;

  /// Returns whether the pose is the same at all times.
  bool IsAtRest() const;

  /// Returns what lms3dTrajectory::Interpolate returns, to the bit, for the times of this part.
  lms3dPose GetPose(double time) const;

private:
  void Add(double time, const lms3dPose& pose);

  std::vector<double> Times;
  std::vector<lms3dPose> Poses;

  /// From each pose to the next.
  std::vector<lms3dPoseSegment> Segments;
};

#endif
