// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the platform carries the fan, and how it turns.
 *
 * A turn has a frame of three axes: F is perpendicular to the platform's axis, A is the axis, and S
 * = A x F. For the platform angle beta the axes F and S are turned about A, clockwise seen from its
 * tip:
 *
 *     F(beta) = cos(beta) F(0) - sin(beta) S(0),    S(beta) = sin(beta) F(0) + cos(beta) S(0).
 *
 * The fan lies in the plane of F and A. An elevation e above the platform's plane stands for the
 * direction cos(e) F + sin(e) A.
 */
#ifndef lms3dPlatform_h
#define lms3dPlatform_h

#include "Geometry/lms3dVector.h"

#include <array>

/// The four ways to mount and turn a fan of Wulf and Wagner 2003, in the order of
/// vtkLMS3DScanFilter::Mountings, which documents them. x, y and z are the sensor's axes.
enum class lms3dMounting
{
  /// F(0) = x, A = z, e = alpha.
  Yawing,

  /// F(0) = x, A = z, e = 90 - alpha.
  YawingTop,

  /// F(0) = x, A = y, e = alpha.
  Pitching,

  /// F(0) = y, A = x, e = 90 - alpha.
  Rolling
};

/// The defaults are the same as in vtkLMS3DScanFilter.
struct lms3dPlatform
{
  lms3dMounting Mounting = lms3dMounting::Yawing;

  /// The position of the mirror's centre, metres, in the sensor's axes while beta is 0. It turns
  /// with the platform.
  lms3dVector AxisOffset = { 0.0, 0.0, 0.0 };

  /// How fast the platform turns while the mirror sweeps a fan, degrees a second.
  double TurnRate = 0.0;

  /// Returns whether all beams start at the sensor's position, and the platform stands still during
  /// each fan.
  bool IsCentredAndStepped() const
  {
    return this->AxisOffset == lms3dVector{ 0.0, 0.0, 0.0 } && this->TurnRate == 0.0;
  }

  /// Returns whether the middle of the fan, and not its ends, lies on the axis.
  bool IsFanAlongAxis() const
  {
    return this->Mounting == lms3dMounting::YawingTop || this->Mounting == lms3dMounting::Rolling;
  }

  bool operator==(const lms3dPlatform& other) const
  {
    return this->Mounting == other.Mounting && this->AxisOffset == other.AxisOffset &&
      this->TurnRate == other.TurnRate;
  }
};

/// Returns F(0), S(0) and A, given the sensor's x, y and z axes.
std::array<lms3dVector, 3> lms3dGetPlatformAxes(
  lms3dMounting mounting, const std::array<lms3dVector, 3>& sensorAxes);

/// Returns the components along F(0), S(0) and A of a vector that is given in the sensor's axes.
lms3dVector lms3dToPlatformAxes(lms3dMounting mounting, const lms3dVector& inSensorAxes);

#endif
