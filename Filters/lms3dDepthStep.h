// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tells whether neighbouring returns lie on one surface or on both sides of a depth step.
 */
#ifndef lms3dDepthStep_h
#define lms3dDepthStep_h

#include "lms3dScanGeometry.h"

#include <algorithm>
#include <cmath>

/**
 * Neighbours a and b lie on one surface where both returned and one of these holds within the
 * tolerance:
 *
 * - their ranges are equal;
 * - the plane through a and the return before it meets b's beam at b, or the same from b's side: so
 *   a floor that is met at a grazing angle stays whole, however far apart its returns are;
 * - the plane from a's side meets b's beam at b or behind it, and that from b's side meets a's beam
 *   at a or behind it: so the planes cross between the two, as floor and wall do at the crease of a
 *   room. At a depth step the nearer surface ends before it would reach the farther return.
 *
 * On a plane, neighbours w of 1/range obey w[i-1] + w[i+1] = 2 cos(step) w[i] along a fan. Along a
 * turn at the elevation e, 2 (1 - cos(step)) sin(e) h is added, the plane's lean, where h is 1/range
 * upwards, along the platform's axis. A plane that never meets the beam goes behind everything;
 * where there is no return before, the range goes on.
 *
 * The tolerance is `depthStep` (metres) plus a share of the nearer range: 2 % or, where neighbours
 * are farther apart, the angle between them in radians, so that a coarse scan joins what leans by
 * 45 degrees as well. Beams 180 degrees apart or more have no surface between them.
 */
class lms3dDepthStep
{
public:
  /// `degrees` lie between neighbours: the step of the fan, or of the turns. Its sign is of no
  /// account.
  lms3dDepthStep(double depthStep, double degrees)
    : Absolute(depthStep)
    , Relative(std::max(SmallestRelative, std::abs(degrees) * RadiansPerDegree))
    , AreNeighbors(std::abs(degrees) < LargestStep)
  {
    double sine, cosine;
    lms3dSinCosDegrees(degrees, sine, cosine);
    this->TwoCosines = 2.0 * cosine;
  }

  /// Whether the middle two of four ranges in a row of a fan are joined; a range of 0 is a miss.
  bool IsJoined(double before, double a, double b, double after) const
  {
    return this->AreEqual(a, b) || this->AreOneSurface(before, a, b, after, 0.0, 0.0);
  }

  ///@{
  /// Along a turn either is enough. Leans are in 1/metre.
  bool AreEqual(double a, double b) const
  {
    return this->AreNeighbors && a > 0.0 && b > 0.0 && std::abs(a - b) <= this->GetTolerance(a, b);
  }

  bool AreOneSurface(
    double before, double a, double b, double after, double leanOfA, double leanOfB) const
  {
    const double tolerance = this->GetTolerance(a, b);
    const Plane fromA = this->GoOn(before, a, leanOfA);
    const Plane fromB = this->GoOn(after, b, leanOfB);
    return this->AreNeighbors && a > 0.0 && b > 0.0 &&
      (fromA.Meets(b, tolerance) || fromB.Meets(a, tolerance) ||
        (fromA.Reaches(b, tolerance) && fromB.Reaches(a, tolerance)));
  }
  ///@}

private:
  static constexpr double SmallestRelative = 0.02;
  static constexpr double LargestStep = 180.0;
  static constexpr double RadiansPerDegree = 3.14159265358979323846 / 180.0;

  /// Meets the next beam at the range Product / Slope, or nowhere without a slope above 0.
  struct Plane
  {
    double Product;
    double Slope;

    bool Meets(double range, double tolerance) const
    {
      return this->Slope > 0.0 &&
        std::abs(this->Product - range * this->Slope) <= tolerance * this->Slope;
    }

    bool Reaches(double range, double tolerance) const
    {
      return this->Product >= std::max(range - tolerance, 0.0) * this->Slope;
    }
  };

  double GetTolerance(double a, double b) const
  {
    return this->Absolute + this->Relative * std::min(a, b);
  }

  Plane GoOn(double before, double at, double lean) const
  {
    const double product = before * at;
    return before > 0.0 ? Plane{ product, this->TwoCosines * before - at + lean * product }
                        : Plane{ at, 1.0 };
  }

  double Absolute;
  double Relative;
  double TwoCosines;
  bool AreNeighbors;
};

#endif
