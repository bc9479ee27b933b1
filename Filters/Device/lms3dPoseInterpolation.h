// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A pose between two poses, and orientations as quaternions.
 */
#ifndef lms3dPoseInterpolation_h
#define lms3dPoseInterpolation_h

#include "Device/lms3dScanGeometry.h"

#include <array>

/// A quaternion w, x, y, z.
using lms3dQuaternion = std::array<double, 4>;

/// Returns the rotation from the sensor frame to the world, of length 1, with w not negative.
lms3dQuaternion lms3dToQuaternion(const std::array<std::array<double, 3>, 3>& axes);

/// Returns the columns of the rotation matrix of a quaternion of any length other than 0. Its
/// squares must be finite.
std::array<std::array<double, 3>, 3> lms3dToAxes(const lms3dQuaternion& quaternion);

/// The way from one pose to another. Computes once what all poses between the two share.
class lms3dPoseSegment
{
public:
  lms3dPoseSegment(const lms3dPose& from, const lms3dPose& to);

  /// Returns the pose at a share of the way, 0 to 1: the position on the straight line, the
  /// orientation by slerp (Shoemake 1985) on the shorter way. Both ends, coordinates that they have
  /// in common, and a common orientation are kept to the bit.
  lms3dPose Interpolate(double share) const;

private:
  lms3dQuaternion Slerp(double share) const;

  lms3dPose From;
  lms3dPose To;

  /// The orientations, on the same side of the four-dimensional sphere, and the angle between them,
  /// radians.
  lms3dQuaternion First;
  lms3dQuaternion Last;
  double Angle;
};

/// Returns the pose of lms3dPoseSegment at a share of the way.
lms3dPose lms3dInterpolate(const lms3dPose& from, const lms3dPose& to, double share);

#endif
