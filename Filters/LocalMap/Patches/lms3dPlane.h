// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Planes as the sensor sees them, and the least-squares plane of returns.
 */
#ifndef lms3dPlane_h
#define lms3dPlane_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <cmath>

/**
 * A plane in the sensor frame that does not pass through the sensor. It has one vector q, 1/metre,
 * with q.p = 1 for each of its points p: q is the normal divided by the distance. A beam of
 * direction d (of length 1) meets the plane where 1 / range = q.d. Therefore, on a plane, the
 * inverse range is linear in the direction.
 */
struct lms3dPlane
{
  lms3dVector Q;

  /// 1/metre. If it is not above 0, the beam does not meet the plane.
  double GetInverseRange(const lms3dVector& direction) const
  {
    return lms3dDot(this->Q, direction);
  }
};

/// A plane restricted to one column of lms3dBeamSphere. There it has two coordinates if beams are
/// regular: evaluating a beam takes two products.
class lms3dColumnPlane
{
public:
  /// Keeps references.
  lms3dColumnPlane(const lms3dPlane& plane, const lms3dBeamSphere& sphere, int column)
    : Plane(plane)
    , Sphere(sphere)
    , Cosines(sphere.GetCosines())
    , Sines(sphere.GetSines())
    , Start(sphere.GetIndex(column, 0))
    , IsRegular(sphere.IsRegular())
    , Horizontal(
        plane.Q[0] * sphere.GetHorizontal(column)[0] + plane.Q[1] * sphere.GetHorizontal(column)[1])
    , Vertical(plane.Q[2])
  {
  }

  /// The inverse of the distance from the origin, 1/metre, in the direction of the entry in a row.
  double GetInverseRange(int row) const
  {
    return this->IsRegular
      ? this->GetInverseRangeOfRegular(row)
      : this->Plane.GetInverseRange(this->Sphere.GetDirection(this->Start + row));
  }

  /// The same if beams are regular.
  double GetInverseRangeOfRegular(int row) const
  {
    return this->Horizontal * this->Cosines[row] + this->Vertical * this->Sines[row];
  }

private:
  const lms3dPlane& Plane;
  const lms3dBeamSphere& Sphere;
  const double* const Cosines;
  const double* const Sines;
  const lms3dBeamSphere::GridIndex Start;
  const bool IsRegular;
  const double Horizontal;
  const double Vertical;
};

/// Whether a return at `range` lies within a tolerance, metres along its beam, of a plane that the
/// beam meets at 1 / `inverseRange`. False if the beam does not meet the plane.
inline bool lms3dIsWithinTolerance(double range, double inverseRange, double tolerance)
{
  return std::abs(range * inverseRange - 1.0) <= tolerance * inverseRange;
}

/// The sums over returns from which their least-squares plane follows. A pole counts once: only its
/// entry in column 0 is added.
class lms3dPlaneFit
{
public:
  /// Adds the returns of a column from one row to another, both included. All must have returns.
  void Add(const lms3dBeamSphere& sphere, int column, int firstRow, int lastRow);
  /// Adds one return.
  void Add(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index);
  /// Adds a point.
  void Add(const lms3dVector& point);
  /// Adds all returns of another fit.
  void Add(const lms3dPlaneFit& other);

  double GetNumberOfReturns() const { return this->Count; }
  /// A vector towards the center of the returns, of any length.
  const lms3dVector& GetCenter() const { return this->Sum; }

  /**
   * The plane that minimizes the sum of the squares of q.p - 1. If the returns do not determine a
   * plane, as one return or a straight row of returns does not, the plane that faces the sensor
   * most. There must be a return.
   */
  lms3dPlane GetPlane() const;

private:
  double Count = 0.0;
  lms3dVector Sum = { 0.0, 0.0, 0.0 };
  /// The sums of xx, xy, xz, yy, yz, zz.
  std::array<double, 6> Products = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
