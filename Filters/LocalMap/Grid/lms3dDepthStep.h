// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides whether neighbouring returns lie on one surface or on both sides of a depth step.
 */
#ifndef lms3dDepthStep_h
#define lms3dDepthStep_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>

/**
 * Ranges are metres; 0 is a beam without a return. Two neighbours a and b lie on one surface if both
 * returned and one of these holds within the tolerance:
 *
 * - Their ranges are equal.
 * - The plane through a and the return before it meets b's beam at b, or the same from b's side. So a
 *   floor at a grazing angle stays whole, however far apart its returns are.
 * - The planes intersect between the two, as floor and wall do at the crease of a room: the plane from
 *   a's side meets b's beam at b or behind it, and the plane from b's side meets a's beam at a or behind
 *   it. The side of an object can intersect the wall far behind it in the same way. Therefore a third
 *   return must confirm it: the nearer side is straight. Otherwise the result is Uncertain, and
 *   lms3dRangeJoins looks at the surface all around.
 *
 * On a plane, three consecutive inverse ranges w along a fan satisfy w[i-1] + w[i+1] = 2 cos(step) w[i].
 * Along a turn at elevation e, the plane's tilt is added: 2 (1 - cos(step)) sin(e) h, where h is the
 * inverse range upwards along the platform's axis. A plane that never meets a beam counts as behind
 * everything. Without a return before, the range stays constant.
 *
 * The tolerance is `depthStep` plus a share of the nearer range: 2 % or, if neighbours are farther apart,
 * the angle between them in radians, so that a coarse scan also joins surfaces inclined by 45 degrees.
 * No surface lies between beams that are 180 degrees apart or more.
 */
class lms3dDepthStep
{
public:
  /// `depthStep` is metres, at least 0. `degrees` is the angle between neighbours, along the fan or along
  /// the turns, of either sign.
  lms3dDepthStep(double depthStep, double degrees)
    : Absolute(depthStep)
    , Relative(std::max(MinimumRelative, std::abs(degrees) * lms3dRadiansPerDegree))
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
    /// The planes intersect, but no third return confirms that the nearer side is straight.
    Uncertain
  };

  /// The relation of two neighbours in a fan, at[0] and at[1]. The ranges at[-2] to at[3] are read.
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
  /// The criteria one by one, for turns. Tilts are in 1/metre, each of the return whose name it has.
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

  /// A plane on the next beam, which it meets at the range Product / Slope. It does not meet the beam if
  /// Slope is not above 0.
  struct Plane
  {
    double Product;
    double Slope;

    /// Whether the plane meets the beam at a range.
    bool Meets(double range, double tolerance) const
    {
      return this->Slope > 0.0 &&
        std::abs(this->Product - range * this->Slope) <= tolerance * this->Slope;
    }

    /// Whether the plane meets the beam at a range or behind it.
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

  /// The plane through a return and the one before it, on the next beam.
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
