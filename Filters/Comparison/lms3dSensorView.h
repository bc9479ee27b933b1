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

/**
 * If the mirror's centre lies beside the platform's axis, beams of different turns start at
 * different points. Two beams lead to a point, on either side of the axis, and either can be
 * covered; `way` is 0 or 1. Both are found in closed form. If all beams start at the sensor's
 * position, there is only the way 0.
 *
 * If the platform turns during a fan, whose beams are interlaced, a point counts as covered from
 * where all turns of the mirror have begun to where the first of them ends.
 */
class lms3dSensorView
{
public:
  /**
   * Reads the field data `SensorToWorld`, `AlphaAngles`, `BetaAngles`, `Mounting`, `AxisOffset` and
   * `TurnRate` of a scan or of its local map. Throws std::runtime_error with a message for the user
   * if one of the first three is missing, or any is invalid.
   */
  lms3dSensorView(vtkFieldData* data, const lms3dRangeLimits& limits);

  /// World coordinates, metres.
  const lms3dVector& GetPosition() const { return this->Position; }

  /// The number of ways: 1 if all beams start at the sensor's position, otherwise 2.
  int GetNumberOfWays() const { return this->IsCentred ? 1 : 2; }

  /// Returns true if a point in world coordinates lies within the angles and ranges. The point may
  /// be hidden by the scene.
  bool Covers(const lms3dVector& point, int way = 0) const;

  /// The distance of a point from the start of its beam, metres.
  double GetRange(const lms3dVector& point, int way = 0) const;

  /// The start of the beam to a point, world coordinates, metres. If no beam leads there, the
  /// sensor's position.
  lms3dVector GetStart(const lms3dVector& point, int way = 0) const;

  /// Alpha and beta, degrees, of the beams that lead to a point. There are two if both halves of a
  /// fan along the axis reach it; otherwise, both are equal. They may lie outside of the scan.
  std::array<std::array<double, 2>, 2> GetAngles(const lms3dVector& point, int way = 0) const;

private:
  /// A beam in the frame of its turn (lms3dPlatform.h): metres along F and A from its start to the
  /// point.
  struct Beam
  {
    double Forward;
    double Along;
    /// The platform angle, degrees.
    double Beta;
    /// False if no beam leads to the point.
    bool Exists;
  };

  Beam FindBeam(const lms3dVector& point, int way) const;
  bool CoversAlpha(double alpha) const;
  bool CoversAngles(double alpha, double beta) const;

  lms3dVector Position;
  /// F(0), S(0) and A in world coordinates.
  std::array<lms3dVector, 3> Axes;
  lms3dRangeLimits Limits;
  lms3dPlatform Platform;
  /// The mirror's centre along F, S and A, metres.
  lms3dVector Offset;
  bool IsCentred;
  /// Degrees. The turn covers BetaExtent, increasing from FirstBeta.
  double LowestAlpha;
  double HighestAlpha;
  double FirstAlpha;
  double FirstBeta;
  double BetaExtent;
  bool IsClosed;
  /// By how much the platform turns from one turn of the mirror to the last one of a fan, and in
  /// one degree of the mirror, degrees.
  double TurnedByFan;
  double TurnedByDegree;
};

#endif
