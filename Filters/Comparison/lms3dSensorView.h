// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The part of space that a scan covers: its angles and ranges around a posed sensor.
 */
#ifndef lms3dSensorView_h
#define lms3dSensorView_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

#include <array>

class vtkFieldData;

class lms3dSensorView
{
public:
  /**
   * Reads the field data `SensorToWorld`, `AlphaAngles` and `BetaAngles` of a scan or of its local
   * map. Throws std::runtime_error with a message for the user if one is missing or invalid.
   */
  lms3dSensorView(vtkFieldData* data, const lms3dRangeLimits& limits);

  /// World coordinates, metres.
  const lms3dVector& GetPosition() const { return this->Position; }

  /// Returns true if a point in world coordinates lies within the angles and ranges. The point may
  /// be hidden by the scene.
  bool Covers(const lms3dVector& point) const;

  /// The distance of a point from the sensor, metres.
  double GetRange(const lms3dVector& point) const;

private:
  lms3dVector Position;
  /// The sensor's x, y and z axes in world coordinates.
  std::array<lms3dVector, 3> Axes;
  lms3dRangeLimits Limits;
  /// Degrees. The turn covers BetaExtent, increasing from FirstBeta.
  double LowestAlpha;
  double HighestAlpha;
  double FirstBeta;
  double BetaExtent;
};

#endif
