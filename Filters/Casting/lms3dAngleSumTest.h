// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The founding paper's test of whether a beam meets a triangle.
 */
#ifndef lms3dAngleSumTest_h
#define lms3dAngleSumTest_h

#include "Casting/lms3dTriangle.h"

#include <algorithm>
#include <cmath>

/// What the test forgives; 0 forgives nothing.
struct lms3dAngleSumTolerances
{
  /// The largest deviation of the sum of angles from 2 pi of a point that counts as inside, radians.
  /// The arc cosine loses half the digits near pi, so that points on an edge deviate by some 1e-8; a
  /// larger tolerance takes points beside the triangle for inside.
  double Angle = 1e-6;

  /// A point that is nearer to a corner than this share of its range is at the corner: rounding has
  /// turned the angle there by more than a tenth of the tolerance.
  double Corner = 1e-9;
};

/**
 * The paper's section 2.4: the intersection with the triangle's plane lies in the triangle where
 * the angles that its corners span there sum to 2 pi. Its slips are repaired: the plane's sign is
 * that of its equation, only ranges above 0 count, a beam parallel to the plane misses it, the sum
 * is compared with a tolerance, and corners, where it is nothing but rounding, belong to the
 * triangle.
 */
class lms3dAngleSumTest
{
public:
  explicit lms3dAngleSumTest(const lms3dSeenTriangle& triangle)
    : lms3dAngleSumTest(triangle, lms3dAngleSumTolerances())
  {
  }

  lms3dAngleSumTest(const lms3dSeenTriangle& triangle, const lms3dAngleSumTolerances& tolerances)
    : Triangle(triangle)
    , Tolerances(tolerances)
  {
    const double(&a)[3] = triangle.Corner[0];
    const double(&b)[3] = triangle.Corner[1];
    const double(&c)[3] = triangle.Corner[2];
    const double p[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double q[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    this->Normal[0] = p[1] * q[2] - p[2] * q[1];
    this->Normal[1] = p[2] * q[0] - p[0] * q[2];
    this->Normal[2] = p[0] * q[1] - p[1] * q[0];
    this->Distance = Dot(this->Normal, a);
  }

  double GetRange(const double direction[3]) const
  {
    const double slope = Dot(this->Normal, direction);
    if (slope == 0.0)
    {
      return 0.0;
    }
    const double range = this->Distance / slope;
    return range > 0.0 && this->Contains(direction, range) ? range : 0.0;
  }

private:
  bool Contains(const double direction[3], double range) const
  {
    double toCorner[3][3];
    double length[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        toCorner[corner][axis] = this->Triangle.Corner[corner][axis] - range * direction[axis];
      }
      length[corner] = std::sqrt(Dot(toCorner[corner], toCorner[corner]));
      if (length[corner] <= this->Tolerances.Corner * range)
      {
        return true;
      }
    }
    constexpr double Pi = 3.14159265358979323846;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const double cosine = Dot(toCorner[i], toCorner[next]) / (length[i] * length[next]);
      sum += std::acos(std::clamp(cosine, -1.0, 1.0));
    }
    return std::abs(sum - 2.0 * Pi) <= this->Tolerances.Angle;
  }

  static double Dot(const double p[3], const double q[3])
  {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }

  const lms3dSeenTriangle Triangle;
  const lms3dAngleSumTolerances Tolerances;
  double Normal[3];
  double Distance;
};

#endif
