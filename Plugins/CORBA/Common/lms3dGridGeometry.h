// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts structures of the IDL to the geometry of the device.
 */
#ifndef lms3dGridGeometry_h
#define lms3dGridGeometry_h

#include "Device/lms3dScanGeometry.h"
#include "LMS3DScanner.hh"

///@{
/// Equal to the geometry, the platform and the pose of vtkLMS3DScanFilter to the bit.
lms3dScanGeometry lms3dGetGeometry(
  const LMS3D::Configuration& settings, const LMS3D::Device& device);
lms3dPlatform lms3dGetPlatform(const LMS3D::Device& device);
lms3dPose lms3dGetPose(const LMS3D::Pose& pose);
///@}

#endif
