// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The orientation, in-triangle and in-circle predicates of points in the plane.
 */
#ifndef lms3dOrientation_h
#define lms3dOrientation_h

#include <array>
#include <cmath>
#include <limits>

/// x and y, in any unit.
using lms3dPoint2 = std::array<double, 2>;

/// As lms3dGetOrientation(), for points that nearly lie on a line.
int lms3dGetExactOrientation(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c);

/// 1 if c lies left of the line from a to b, -1 if right of it, 0 if on it. Exact for all finite
/// coordinates whose products neither overflow nor underflow.
inline int lms3dGetOrientation(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c)
{
  // Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
  // predicates": the rounding error of the determinant in plain arithmetic.
  constexpr double HalfUlp = std::numeric_limits<double>::epsilon() / 2.0;
  constexpr double Error = (3.0 + 16.0 * HalfUlp) * HalfUlp;
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  if (std::abs(determinant) > Error * (std::abs(left) + std::abs(right)))
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return lms3dGetExactOrientation(a, b, c);
}

/// Whether a point lies in a triangle, or on its border. `orientation` is that of the triangle, not
/// 0.
bool lms3dIsInTriangle(
  const lms3dPoint2& point, const std::array<lms3dPoint2, 3>& triangle, int orientation);

/// Whether d lies inside the circle through a, b and c (counter-clockwise) by more than a rounding
/// error. Therefore, of the two diagonals of four points, at most one is ever preferred.
bool lms3dIsInCircle(
  const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c, const lms3dPoint2& d);

#endif
