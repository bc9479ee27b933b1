// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Validates poses, configurations and devices of clients.
 */
#ifndef lms3dSettingsCheck_h
#define lms3dSettingsCheck_h

#include "LMS3DScanner.hh"

/// Beams of a scan.
constexpr CORBA::ULongLong lms3dMaximumBeams = 4000000;

/// The LMS 200's grid of 361 x 360 beams, ranges up to 80 m, and a map with an error bound of 1 cm.
LMS3D::Configuration lms3dDefaultConfiguration();

///@{
/// Throw LMS3D::InvalidArgument with the wrong value and its limits, or LMS3D::LimitExceeded for
/// too many beams or rays. lms3dCheckRays() expects a valid configuration and a valid device.
void lms3dCheckPose(const LMS3D::Pose& pose);
void lms3dCheckConfiguration(const LMS3D::Configuration& configuration);
void lms3dCheckDevice(const LMS3D::Device& device);
void lms3dCheckRays(const LMS3D::Configuration& configuration, const LMS3D::Device& device);
///@}

#endif
