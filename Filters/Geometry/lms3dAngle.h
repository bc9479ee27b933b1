// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Constants of angles. Properties are in degrees, computations in radians.
 */
#ifndef lms3dAngle_h
#define lms3dAngle_h

constexpr double lms3dPi = 3.14159265358979323846;
constexpr double lms3dRadiansPerDegree = lms3dPi / 180.0;
constexpr double lms3dDegreesPerRadian = 180.0 / lms3dPi;

#endif
