// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The planes on both sides of a pair of lms3dDepthStep.
#include "LocalMap/Grid/lms3dDepthStep.h"

#include <algorithm>

namespace
{
double Square(double x)
{
  return x * x;
}
} // namespace

lms3dDepthStep::Plane lms3dDepthStep::GetPlane(const Side& side) const
{
  const auto [last, before, first] = side.Ranges;
  const auto& [tilt, tiltBefore] = side.Tilts;
  Plane plane;
  plane.Inverse = 1.0 / last;
  plane.Variance = this->GetVariance(plane.Inverse);
  plane.HasBend = before > 0.0 && first > 0.0;
  if (!(before > 0.0))
  {
    plane.Next = plane.Inverse;
    plane.VarianceOfNext = plane.Variance;
    return plane;
  }
  const double middle = 1.0 / before;
  const double varianceOfMiddle = this->GetVariance(middle);
  plane.Next = this->TwoCosines * plane.Inverse - middle + tilt.Value;
  plane.VarianceOfTilt = tilt.Variance;
  plane.VarianceOfNext =
    Square(this->TwoCosines) * plane.Variance + varianceOfMiddle + tilt.Variance;
  if (plane.HasBend)
  {
    // The tilt is the same all over a plane.
    const double start = 1.0 / first;
    const double untilted = plane.Inverse + start - this->TwoCosines * middle;
    const double bend = untilted - tilt.Value;
    const double bendBefore = untilted - tiltBefore.Value;
    plane.Bend = std::abs(bend) < std::abs(bendBefore) ? bend : bendBefore;
    plane.VarianceOfBend = plane.Variance + this->GetVariance(start) +
      Square(this->TwoCosines) * varianceOfMiddle + tiltBefore.Variance;
  }
  return plane;
}

bool lms3dDepthStep::IsStraight(const Plane& plane) const
{
  const double expected = std::max(plane.Inverse - plane.Bend, 0.0);
  return plane.HasBend &&
    std::abs(plane.Bend) <=
    this->Flatness * plane.Inverse * expected + Deviations * std::sqrt(plane.VarianceOfBend);
}

// The plane that fits three returns best, if they are straight. The fit moves them in the ratio 1 :
// -2 : 1, which takes two thirds of the bend from the continuation. (For small angles between
// beams.)
lms3dDepthStep::Plane lms3dDepthStep::Fit(const Plane& plane) const
{
  Plane fit = plane;
  if (this->Variance > 0.0 && this->IsStraight(plane))
  {
    constexpr double ShareOfBend = 2.0 / 3.0;
    const double withoutTilt = plane.VarianceOfNext - plane.VarianceOfTilt;
    // From 5 variances of one return to 7/3.
    constexpr double ShareOfVariance = 7.0 / 15.0;
    fit.Next -= ShareOfBend * plane.Bend;
    fit.VarianceOfNext = ShareOfVariance * withoutTilt + 2.0 * plane.VarianceOfTilt;
  }
  return fit;
}
