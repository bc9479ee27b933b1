// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sum of squared distances to planes.
 */
#ifndef lms3dQuadric_h
#define lms3dQuadric_h

#include "Geometry/lms3dVector.h"

#include <array>

/// Garland and Heckbert 1997, "Surface simplification using quadric error metrics": the sum of
/// weighted squared distances to planes and points is a quadratic function of the place.
class lms3dQuadric
{
public:
  /// Adds the plane of a triangle. The weight is the area.
  void AddTriangle(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c);
  void AddPoint(const lms3dVector& point, double weight);
  void Add(const lms3dQuadric& other);
  double GetValue(const lms3dVector& point) const;
  /// The point with the smallest value. The quadric must contain a point.
  lms3dVector GetMinimum() const;

private:
  /// The factors of xx, xy, xz, yy, yz, zz.
  std::array<double, 6> Matrix = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  lms3dVector Linear = { 0.0, 0.0, 0.0 };
  double Constant = 0.0;
};

#endif
