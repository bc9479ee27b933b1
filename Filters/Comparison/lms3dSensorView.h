// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The part of space that a scan covers.
 */
#ifndef lms3dSensorView_h
#define lms3dSensorView_h

#include "Device/lms3dScanGeometry.h"

#include <array>

class vtkFieldData;

class lms3dSensorView
{
public:
  /**
   * From `SensorToWorld`, `AlphaAngles` and `BetaAngles`, as a scan and its local map carry them.
   * Throws std::runtime_error, with words for the user, where one of them is missing or bad.
   */
  lms3dSensorView(vtkFieldData* data, const lms3dRangeLimits& limits);

  const double* GetPosition() const { return this->Position.data(); }

  /// Whether a point, in world coordinates, lies within the angles and ranges, whatever is before
  /// it.
  bool Covers(const std::array<double, 3>& point) const;

  /// The length of the beam to a point, metres.
  double GetRange(const std::array<double, 3>& point) const;

private:
  std::array<double, 3> Position;
  /// The sensor's x, y and z axes in world coordinates.
  std::array<std::array<double, 3>, 3> Axes;
  lms3dRangeLimits Limits;
  /// Degrees; the turn starts at the first.
  double LowestAlpha;
  double HighestAlpha;
  double FirstBeta;
  double BetaExtent;
};

#endif
