// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tells whether neighbouring returns lie on one surface or on both sides of a depth step.
 */
#ifndef lms3dDepthStep_h
#define lms3dDepthStep_h

#include "Device/lms3dScanGeometry.h"

#include <algorithm>
#include <cmath>

/**
 * Neighbours a and b lie on one surface where both returned and one of these holds within the
 * tolerance:
 *
 * - their ranges are equal;
 * - the plane through a and the return before it meets b's beam at b, or the same from b's side: so
 *   a floor that is met at a grazing angle stays whole, however far apart its returns are;
 * - the planes cross between the two, as floor and wall do at the crease of a room: that from a's
 *   side meets b's beam at b or behind it, and that from b's side meets a's beam at a or behind it.
 *   The side of an object may cross the wall far behind it in the same way, so this needs the word
 *   of a third return: that the nearer side is straight, or (lms3dRangeJoins) that the surface is
 *   whole all around.
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
    , Relative(std::max(MinimumRelative, std::abs(degrees) * RadiansPerDegree))
    , AreNeighbors(std::abs(degrees) < MaximumStep)
  {
    double sine, cosine;
    lms3dSinCosDegrees(degrees, sine, cosine);
    this->TwoCosines = 2.0 * cosine;
  }

  enum Relation
  {
    Separate,
    Joined,
    /// The planes cross, and no third return says that the nearer side is straight.
    Uncertain
  };

  /// Of two neighbours in the row of a fan, the second at `at[1]`; from at[-2] to at[3] there are
  /// ranges. 0 is a miss.
  Relation Classify(const double* at) const
  {
    if (this->AreRangesEqual(at[0], at[1]) ||
      this->AreCoplanar(at[-1], at[0], at[1], at[2], 0.0, 0.0))
    {
      return Joined;
    }
    if (!this->DoPlanesIntersect(at[-1], at[0], at[1], at[2], 0.0, 0.0))
    {
      return Separate;
    }
    const bool isStraight = at[0] < at[1] ? this->IsStraight(at[-2], at[-1], at[0], 0.0)
                                          : this->IsStraight(at[3], at[2], at[1], 0.0);
    return isStraight ? Joined : Uncertain;
  }

  ///@{
  /// The parts of this, for turns. Leans are in 1/metre, those of the return before the last.
  bool AreRangesEqual(double a, double b) const
  {
    return this->AreReturns(a, b) && std::abs(a - b) <= this->GetTolerance(a, b);
  }

  bool AreCoplanar(
    double before, double a, double b, double after, double tiltOfA, double tiltOfB) const
  {
    const double tolerance = this->GetTolerance(a, b);
    return this->AreReturns(a, b) &&
      (this->Extrapolate(before, a, tiltOfA).Meets(b, tolerance) ||
        this->Extrapolate(after, b, tiltOfB).Meets(a, tolerance));
  }

  bool DoPlanesIntersect(
    double before, double a, double b, double after, double tiltOfA, double tiltOfB) const
  {
    const double tolerance = this->GetTolerance(a, b);
    return this->AreReturns(a, b) && this->Extrapolate(before, a, tiltOfA).Reaches(b, tolerance) &&
      this->Extrapolate(after, b, tiltOfB).Reaches(a, tolerance);
  }

  bool IsStraight(double first, double second, double third, double tiltOfSecond) const
  {
    return this->AreReturns(first, second) && third > 0.0 &&
      this->Extrapolate(first, second, tiltOfSecond)
        .Meets(third, this->GetTolerance(second, third));
  }
  ///@}

private:
  static constexpr double MinimumRelative = 0.02;
  static constexpr double MaximumStep = 180.0;
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

  bool AreReturns(double a, double b) const { return this->AreNeighbors && a > 0.0 && b > 0.0; }

  double GetTolerance(double a, double b) const
  {
    return this->Absolute + this->Relative * std::min(a, b);
  }

  Plane Extrapolate(double before, double at, double tilt) const
  {
    const double product = before * at;
    return before > 0.0 ? Plane{ product, this->TwoCosines * before - at + tilt * product }
                        : Plane{ at, 1.0 };
  }

  double Absolute;
  double Relative;
  double TwoCosines;
  bool AreNeighbors;
};

#endif
