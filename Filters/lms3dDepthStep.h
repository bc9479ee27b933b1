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
 * Neighbours a and b lie on one surface where their ranges differ by no more than the tolerance, or
 * where the plane through a and the return before it meets b's beam within the tolerance of b (or
 * the same from b's side): so a floor that is met at a grazing angle stays whole, however far apart
 * its returns are. On a plane, neighbours w of 1/range obey w[i-1] + w[i+1] = 2 cos(step) w[i];
 * that is exact along a fan, and along a turn for planes that are level or upright.
 *
 * The tolerance is `depthStep` (metres) plus a share of the nearer range: 2 % or, where neighbours
 * are farther apart, the angle between them in radians, so that a coarse scan joins what leans by
 * 45 degrees as well.
 */
class lms3dDepthStep
{
public:
  /// `degrees` lie between neighbours: the step of the fan, or of the turns.
  lms3dDepthStep(double depthStep, double degrees)
    : Absolute(depthStep)
  {
    double sine, cosine;
    lms3dSinCosDegrees(degrees, sine, cosine);
    this->TwoCosines = 2.0 * cosine;
    this->Relative = std::max(SmallestRelative, std::atan2(sine, cosine));
  }

  /// Whether the middle two of four ranges in a row are joined; a range of 0 is a miss.
  bool IsJoined(double before, double a, double b, double after) const
  {
    const double tolerance = this->Absolute + this->Relative * std::min(a, b);
    return a > 0.0 && b > 0.0 &&
      (std::abs(a - b) <= tolerance || this->IsPredicted(before, a, b, tolerance) ||
        this->IsPredicted(after, b, a, tolerance));
  }

private:
  static constexpr double SmallestRelative = 0.02;

  // The plane through `before` and `at` goes on to the range before * at / slope. A miss before
  // leaves no positive slope.
  bool IsPredicted(double before, double at, double next, double tolerance) const
  {
    const double slope = this->TwoCosines * before - at;
    return slope > 0.0 && std::abs(before * at - next * slope) <= tolerance * slope;
  }

  double Absolute;
  double Relative;
  double TwoCosines;
};

#endif
