// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Planes as the sensor sees them, and the fit of a plane to returns.
 */
#ifndef lms3dPlane_h
#define lms3dPlane_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <cmath>

/**
 * A plane that does not pass through the sensor has one vector q with q.p = 1 for each of its
 * points p. A beam along d meets it where 1 / range = q.d: on a plane, the inverse of the range is
 * linear in the direction, whatever the angles of the beams.
 */
struct lms3dPlane
{
  lms3dVector Q;

  double GetInverseRange(const lms3dVector& direction) const
  {
    return lms3dDot(this->Q, direction);
  }
};

/// A plane in the frame of a column: one loop of two products a beam compares a whole column.
struct lms3dColumnPlane
{
  lms3dColumnPlane(const lms3dPlane& plane, const lms3dBeamSphere& sphere, int column)
    : Level(plane.Q[0] * sphere.GetLevel(column)[0] + plane.Q[1] * sphere.GetLevel(column)[1])
    , Upward(plane.Q[2])
  {
  }

  double GetInverseRange(double cosine, double sine) const
  {
    return this->Level * cosine + this->Upward * sine;
  }

  double Level;
  double Upward;
};

/// Whether a return lies within a tolerance of a plane, both in metres along its beam.
inline bool lms3dIsWithinTolerance(double range, double inverseRange, double tolerance)
{
  return std::abs(range * inverseRange - 1.0) <= tolerance * inverseRange;
}

/// The sums over returns that the best plane follows from.
class lms3dPlaneFit
{
public:
  /// Adds the returns of a column from one row to another, both included.
  void Add(const lms3dBeamSphere& sphere, int column, int firstRow, int lastRow);
  void Add(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index);
  void Add(const lms3dPlaneFit& other);

  double GetNumberOfReturns() const { return this->Count; }
  /// Towards the center of the returns, of any length.
  const lms3dVector& GetCenter() const { return this->Sum; }

  /**
   * The plane of least squares of q.p - 1. Where the returns leave it open, as one return or a row
   * of them does, the plane that faces the sensor most.
   */
  lms3dPlane GetPlane() const;

  /// The sum of the squares of q.p - 1.
  double GetSquaredResidual(const lms3dPlane& plane) const;

private:
  double Count = 0.0;
  lms3dVector Sum = { 0.0, 0.0, 0.0 };
  /// xx, xy, xz, yy, yz, zz.
  std::array<double, 6> Products = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
