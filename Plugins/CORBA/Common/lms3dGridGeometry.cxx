// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dGridGeometry.h"

lms3dScanGeometry lms3dGetGeometry(const LMS3D::Configuration& settings)
{
  const double alpha[2] = { settings.alpha.start, settings.alpha.stop };
  const double beta[2] = { settings.beta.start, settings.beta.stop };
  return lms3dScanGeometry(
    alpha, static_cast<int>(settings.alpha.count), beta, static_cast<int>(settings.beta.count));
}

lms3dPose lms3dGetPose(const LMS3D::Pose& pose)
{
  const double position[3] = { pose.position.x, pose.position.y, pose.position.z };
  const double orientation[3] = { pose.orientation.x, pose.orientation.y, pose.orientation.z };
  return lms3dPose::FromOrientation(position, orientation);
}
