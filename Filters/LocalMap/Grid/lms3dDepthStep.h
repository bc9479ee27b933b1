// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides whether neighbouring returns lie on one surface or on both sides of a depth step.
 */
#ifndef lms3dDepthStep_h
#define lms3dDepthStep_h

#include "Device/lms3dScanGeometry.h"

#include <array>
#include <cmath>
#include <cstdint>

/**
 * Ranges are metres; 0 is a beam without a return. Two neighbours lie on one surface if both
 * returned and their ranges differ by at most the depth step. If they differ by more, the planes on
 * both sides decide. The last three returns before the pair give each plane. It meets the other
 * beam before the return there, behind it, or at it. At the return means within 2 cm (or a fifth of
 * the depth step) and 4.5 standard deviations of the noise, so a floor at a grazing angle stays
 * whole, however far apart its returns are.
 *
 * - If one plane meets the other beam before its return, and the other plane behind, the planes do
 *   not intersect between the beams. The returns are Separate. If three returns show each plane,
 *   both gaps exceed the depth step (and 5 mm), and the ranges differ by more than 1.5 depth steps,
 *   no two planes explain one surface: the pair is certain. (A narrow slope in between is cut, too.
 *   Otherwise, if both gaps are small, below 1.8 depth steps, and one is within the
 *   tolerance, no larger step fits in between: they are Joined. If the slope from one return to the
 *   other is gentle (lms3dSlopeLimits), they are Joined as well where both planes are steeper, or
 *   where both sides are curved and one gap is within the tolerance.)
 * - If both planes meet the other beam at its return, they are Joined.
 * - Otherwise the planes intersect between the beams, as floor and wall do at the crease of a room.
 *   The side of an object can intersect the wall far behind it in the same way. Therefore a third
 *   return must confirm a plane: at a concave crease the near one, at a convex crease the far one.
 *   Then the returns are Likely on one surface or a Crease, otherwise Uncertain. In a fine scan, a
 *   slope that is steep and that only two returns show is Separate. One that is gentle is Likely if
 *   a plane meets a return, or, along a fan, if the near side is curved.
 *
 * Within the tolerance, returns are Joined unless they are Separate. The tolerance is the depth
 * step plus a share of the nearer range: 2 % or, if neighbours are farther apart, the angle between
 * them in radians, so that a coarse scan also joins surfaces inclined by 45 degrees.
 *
 * If the beams are so far apart that the tolerance exceeds six depth steps, the surface around
 * decides two kinds of pairs (lms3dJoinResolver). Joined pairs are Loose instead if the ranges
 * differ by more than two depth steps, one plane misses the other return by more than five, and the
 * other plane does not meet it within half of one (at least 1 mm). Separate pairs that are not
 * certain are Gentle instead if the slope is gentle and the tolerance is at most 30 depth steps.
 *
 * On a plane, three consecutive inverse ranges w along a fan satisfy w[i-1] + w[i+1] = 2 cos(step)
 * w[i]. Along a turn at elevation e, the plane's tilt is added: 2 (1 - cos(step)) sin(e) h, where h
 * is the inverse range upwards along the platform's axis. Without a return before, the range stays
 * constant.
 *
 * No surface lies between beams that are 180 degrees apart or more.
 */
class lms3dDepthStep
{
public:
  /// The number of standard deviations of the noise that a gap must exceed.
  static constexpr double Deviations = 4.5;

  /// `depthStep` is metres, at least 0. `degrees` is the angle between neighbours, along the fan or
  /// along the turns, of either sign. `noise` is the standard deviation of ranges, metres.
  lms3dDepthStep(double depthStep, double degrees, double noise = 0.0);

  enum Relation
  {
    Separate,
    Joined,
    /// The planes explain one surface.
    Likely,
    /// The same, unless the pair is beside a depth step.
    Crease,
    /// The returns are within the tolerance, but both planes miss the other return: one surface,
    /// unless it is open around the pair.
    Loose,
    /// The planes do not intersect, but the slope is gentle and the pair is not certain: no
    /// surface, unless it is whole around the pair.
    Gentle,
    /// The returns and those before them do not decide.
    Uncertain,
    /// The same, because of noise.
    Noisy
  };

  /// A plane's tilt along turns, 1/metre, and its variance.
  struct Tilt
  {
    double Value = 0.0;
    double Variance = 0.0;
  };

  /// The last return of a surface and the two before it, the last one first, with two tilts.
  struct Side
  {
    std::array<double, 3> Ranges;
    std::array<Tilt, 2> Tilts;
  };

  /// The inverse range of a return, its continuation at the next beam, and the bend of the three
  /// returns, 1/metre.
  struct Plane
  {
    double Inverse = 0.0;
    double Variance = 0.0;
    double Next = 0.0;
    double VarianceOfNext = 0.0;
    double Bend = 0.0;
    double VarianceOfBend = 0.0;
    double VarianceOfTilt = 0.0;
    /// Whether there are three returns.
    bool HasBend = true;

    /// Adds a plane times a weight.
    void Add(const Plane& other, double weight)
    {
      this->Inverse += weight * other.Inverse;
      this->Variance += weight * weight * other.Variance;
      this->Next += weight * other.Next;
      this->VarianceOfNext += weight * weight * other.VarianceOfNext;
      this->Bend += weight * other.Bend;
      this->VarianceOfBend += weight * weight * other.VarianceOfBend;
      this->VarianceOfTilt += weight * weight * other.VarianceOfTilt;
      this->HasBend = this->HasBend && other.HasBend;
    }
  };

  /// Whether two neighbours returned at ranges within the depth step.
  bool AreNear(double a, double b) const
  {
    return this->AreReturns(a, b) && std::abs(a - b) <= this->Absolute;
  }

  /// Sets a flag, one or more bits, for each of `count` pairs of neighbours a[i] and b[i] that
  /// AreNear().
  void FlagNear(
    const double* a, const double* b, int count, std::uint8_t flag, std::uint8_t* flags) const;

  /// Whether two neighbours returned at ranges within the depth step and the share of the range.
  bool AreRangesEqual(double a, double b) const
  {
    return this->AreReturns(a, b) && std::abs(a - b) <= this->GetTolerance(a, b);
  }

  /// The relation of two neighbours in a fan, at[0] and at[1]. The ranges at[-2] to at[3] are read.
  Relation Classify(const double* at) const
  {
    return this->AreNear(at[0], at[1]) || this->AreCoplanar(at) ? Joined : this->ClassifyInFan(at);
  }

  ///@{
  /// The sides of two neighbours in a fan, as Classify() reads them.
  static Side GetSideBefore(const double* at) { return { { at[0], at[-1], at[-2] }, {} }; }
  static Side GetSideBehind(const double* at) { return { { at[1], at[2], at[3] }, {} }; }
  ///@}

  ///@{
  /// The relation of two returns, or of the means over several pairs of two surfaces.
  Relation Classify(const Side& a, const Side& b) const;
  Relation ClassifyMeans(const Plane& a, const Plane& b) const
  {
    return this->Classify(this->Compare(a, b));
  }
  ///@}

  /// The plane of a side whose last beam returned.
  Plane GetPlane(const Side& side) const;

  /// Whether three returns show that a surface is no plane.
  bool IsCurved(const Plane& plane) const { return plane.HasBend && !this->IsStraight(plane); }

  /// Whether a pair is Joined, Likely, a Crease or Loose.
  static bool IsOneSurface(Relation relation) { return relation <= Loose && relation != Separate; }

  /// Whether two neighbours in a fan lie on one surface.
  bool IsOneSurface(const double* at) const { return IsOneSurface(this->Classify(at)); }

  /// The variance of an inverse range due to noise.
  double GetVariance(double inverse) const
  {
    return this->Variance * (inverse * inverse) * (inverse * inverse);
  }

private:
  /// Square metres.
  static constexpr double NegligibleVariance = 1e-12;
  /// The share of the range that counts as no step.
  static constexpr double MinimumRelative = 0.02;

  /// Where a plane meets a beam, compared with the return there.
  struct Gap
  {
    enum Place
    {
      Before,
      AtReturn,
      Behind
    };
    Place At;
    /// Metres.
    double Size;
    /// The difference of the inverse ranges, without sign.
    double InInverse;
    /// Whether noise could hide a depth step behind the return.
    bool IsVague;
  };

  /// Two returns. The near plane meets the far beam, the far plane the near beam.
  struct Pair
  {
    Plane Near;
    Plane Far;
    Gap AtFar;
    Gap AtNear;
    double Tolerance;
    /// The difference of the ranges.
    double Difference;
  };

  bool AreReturns(double a, double b) const { return this->AreNeighbors && a > 0.0 && b > 0.0; }

  /// Whether both planes meet the other return, without noise. This is faster than Classify(),
  /// which finds the same.
  bool AreCoplanar(const double* at) const
  {
    return this->Variance < NegligibleVariance && this->AreReturns(at[0], at[1]) && at[-1] > 0.0 &&
      at[2] > 0.0 && this->Meets(at[-1], at[0], at[1]) && this->Meets(at[2], at[1], at[0]);
  }

  /// Whether the plane through two returns meets the next one.
  bool Meets(double before, double at, double next) const
  {
    const double slope = this->TwoCosines * before - at;
    return slope > 0.0 && std::abs(before * at - next * slope) <= this->Flatness * slope;
  }

  double GetTolerance(double a, double b) const
  {
    return this->Absolute + this->Relative * (a < b ? a : b);
  }
  bool IsStraight(const Plane& plane) const;
  Plane Fit(const Plane& plane) const;
  Gap Measure(const Plane& plane, const Plane& other) const;
  Pair Compare(const Plane& a, const Plane& b) const;
  Relation ClassifyInFan(const double* at) const;
  Relation ClassifyAlone(const Pair& pair) const;
  Relation Classify(const Pair& pair) const;
  Relation ClassifyCrease(const Pair& pair) const;
  /// The tangent of incidence of the line through both returns.
  double GetSlope(const Pair& pair) const
  {
    return pair.Difference * pair.Near.Inverse / this->Angle;
  }
  bool IsGentleBetween(const Pair& pair) const;
  bool IsGentle(const Pair& pair, double gentle) const
  {
    return this->Relative == MinimumRelative && this->GetSlope(pair) <= gentle;
  }
  bool IsTooSteep(const Pair& pair) const;
  bool IsLoose(const Pair& pair) const;
  Relation ClassifyApart(const Pair& pair) const;

  double Absolute;
  double Relative;
  double Flatness;
  double Angle;
  double Variance;
  double TwoCosines;
  bool AreNeighbors;
};

#endif
