// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The poses of a moving sensor, read from a polyline or a set of points.
 */
#ifndef lms3dTrajectory_h
#define lms3dTrajectory_h

#include "Device/lms3dScanGeometry.h"

#include <vector>

class vtkPolyData;

/// Poses in world coordinates, metres.
class lms3dTrajectory
{
public:
  /**
   * Reads a pose from each point of the polyline, in its order, or of all points if there is no
   * line. The header of vtkLMS3DScanFilter documents the arrays `Orientation` and `Time`.
   * `orientation` (degrees, as vtkProp3D applies it) holds if there are neither quaternions nor a
   * polyline. Copies all values. Throws std::runtime_error, with a text for the user, if the
   * trajectory is bad.
   */
  lms3dTrajectory(vtkPolyData* poses, const double orientation[3]);

  /// Returns the times of the poses. They increase, and there is at least one.
  const std::vector<double>& GetTimes() const { return this->Times; }

  /// Returns the last pose that is not later than `time`, or the first pose if all are later.
  int FindStep(double time) const;

  const lms3dPose& GetPose(int step) const { return this->Poses[step]; }

  /// Returns the pose at any time: positions are interpolated linearly, orientations by slerp
  /// (Shoemake 1985) on the shorter way. Before the first time and after the last it is the first
  /// and the last pose.
  lms3dPose Interpolate(double time) const;

private:
  std::vector<double> Times;
  std::vector<lms3dPose> Poses;
};

#endif
