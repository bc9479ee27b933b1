// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The angle-sum test of whether a beam hits a triangle, as in the founding paper.
 */
#ifndef lms3dAngleSumTest_h
#define lms3dAngleSumTest_h

#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <cmath>

/// Tolerances of the test.
struct lms3dAngleSumTolerances
{
  /// A point counts as inside if its sum of angles deviates from 2 pi by at most this, radians. The
  /// arc cosine loses half its digits near pi, so that points on an edge deviate by about 1e-8. A
  /// larger tolerance accepts points beside the triangle.
  double Angle = 1e-6;

  /// A point counts as inside if its distance from a corner is at most this share of its range,
  /// because rounding changes the angle there by more than a tenth of the other tolerance.
  double Corner = 1e-9;
};

/**
 * Source: the paper's section 2.4. The point where a beam meets the triangle's plane lies inside
 * the triangle if the angles between the directions to the three corners sum to 2 pi. Five errors
 * of the paper are corrected: the sign of the plane's equation; only ranges above 0 count; a beam
 * parallel to the plane misses; the sum is compared with a tolerance; and corners belong to the
 * triangle, although rounding determines the sum there.
 */
class lms3dAngleSumTest
{
public:
  explicit lms3dAngleSumTest(const lms3dSensorFrameTriangle& triangle)
    : lms3dAngleSumTest(triangle, lms3dAngleSumTolerances())
  {
  }

  lms3dAngleSumTest(
    const lms3dSensorFrameTriangle& triangle, const lms3dAngleSumTolerances& tolerances)
    : Triangle(triangle)
    , Tolerances(tolerances)
  {
    const double* a = triangle.Corner[0];
    this->Normal =
      lms3dCross(lms3dSubtract(triangle.Corner[1], a), lms3dSubtract(triangle.Corner[2], a));
    this->Distance = lms3dDot(this->Normal, { a[0], a[1], a[2] });
  }

  double GetRange(const lms3dVector& direction) const
  {
    const double slope = lms3dDot(this->Normal, direction);
    if (slope == 0.0)
    {
      return 0.0;
    }
    const double range = this->Distance / slope;
    return range > 0.0 && this->Contains(direction, range) ? range : 0.0;
  }

private:
  bool Contains(const lms3dVector& direction, double range) const
  {
    lms3dVector toCorner[3];
    double length[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        toCorner[corner][axis] = this->Triangle.Corner[corner][axis] - range * direction[axis];
      }
      length[corner] = std::sqrt(lms3dDot(toCorner[corner], toCorner[corner]));
      if (length[corner] <= this->Tolerances.Corner * range)
      {
        return true;
      }
    }
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const double cosine = lms3dDot(toCorner[i], toCorner[next]) / (length[i] * length[next]);
      sum += std::acos(std::clamp(cosine, -1.0, 1.0));
    }
    return std::abs(sum - 2.0 * lms3dPi) <= this->Tolerances.Angle;
  }

  const lms3dSensorFrameTriangle Triangle;
  const lms3dAngleSumTolerances Tolerances;
  lms3dVector Normal;
  double Distance;
};

#endif
