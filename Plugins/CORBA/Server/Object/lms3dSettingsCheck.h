// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which poses and configurations the scanner takes.
 */
#ifndef lms3dSettingsCheck_h
#define lms3dSettingsCheck_h

#include "LMS3DScanner.hh"

/// The most beams of a scan.
constexpr CORBA::ULongLong lms3dMostBeams = 4000000;

/// The LMS 200's grid of 361 x 360 beams, 80 m, and a map within 1 cm.
LMS3D::Configuration lms3dDefaultConfiguration();

///@{
/// Throw LMS3D::InvalidArgument, or LMS3D::LimitExceeded for too many beams, which says what is wrong.
void lms3dCheckPose(const LMS3D::Pose& pose);
void lms3dCheckConfiguration(const LMS3D::Configuration& configuration);
///@}

#endif
