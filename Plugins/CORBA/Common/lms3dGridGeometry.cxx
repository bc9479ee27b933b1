// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dGridGeometry.h"

static_assert(static_cast<int>(LMS3D::MOUNTING_YAWING) == static_cast<int>(lms3dMounting::Yawing) &&
    static_cast<int>(LMS3D::MOUNTING_YAWING_TOP) == static_cast<int>(lms3dMounting::YawingTop) &&
    static_cast<int>(LMS3D::MOUNTING_PITCHING) == static_cast<int>(lms3dMounting::Pitching) &&
    static_cast<int>(LMS3D::MOUNTING_ROLLING) == static_cast<int>(lms3dMounting::Rolling),
  "the interface and the platform number the mountings alike");

lms3dPlatform lms3dGetPlatform(const LMS3D::Device& device)
{
  const LMS3D::Vector3& offset = device.axisOffset;
  return { static_cast<lms3dMounting>(static_cast<int>(device.mounting)),
    { offset.x, offset.y, offset.z }, device.turnRate };
}

lms3dScanGeometry lms3dGetGeometry(
  const LMS3D::Configuration& settings, const LMS3D::Device& device)
{
  const double alpha[2] = { settings.alpha.start, settings.alpha.stop };
  const double beta[2] = { settings.beta.start, settings.beta.stop };
  return lms3dScanGeometry(alpha, static_cast<int>(settings.alpha.count), beta,
    static_cast<int>(settings.beta.count), lms3dGetPlatform(device));
}

lms3dPose lms3dGetPose(const LMS3D::Pose& pose)
{
  const double position[3] = { pose.position.x, pose.position.y, pose.position.z };
  const double orientation[3] = { pose.orientation.x, pose.orientation.y, pose.orientation.z };
  return lms3dPose::FromOrientation(position, orientation);
}
