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

class lms3dTrajectory
{
public:
  /**
   * A pose for each point: in the order of the polyline, where there is one, else in their own.
   * vtkLMS3DScanFilter tells what the arrays `Orientation` and `Time` mean; `orientation` is that of
   * vtkProp3D, for points that have neither quaternions nor a polyline. Throws std::runtime_error,
   * with words for the user, where the trajectory is bad.
   */
  lms3dTrajectory(vtkPolyData* poses, const double orientation[3]);

  /// Increasing, one for each pose.
  const std::vector<double>& GetTimes() const { return this->Times; }

  /// The last pose whose time has come; before the first that one.
  int FindStep(double time) const;

  const lms3dPose& GetPose(int step) const { return this->Poses[step]; }

private:
  std::vector<double> Times;
  std::vector<lms3dPose> Poses;
};

#endif
