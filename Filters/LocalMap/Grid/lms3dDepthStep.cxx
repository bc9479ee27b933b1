// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dDepthStep.h"

#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <limits>

namespace
{
// The share of the range that counts as no step.
constexpr double MinimumRelative = 0.02;
constexpr double MaximumStep = 180.0;
// Real surfaces bend by this distance from a plane, metres: at most, as a share of the depth step, and at least.
constexpr double MaximumFlatness = 0.02;
constexpr double FlatnessOfStep = 0.2;
constexpr double MinimumFlatness = 0.001;
// The largest gap, in depth steps, that is not separated where neither plane meets the other return.
constexpr double LargestGap = 1.8;
// A crease is small if a gap beside it has at most this number of depth steps.
constexpr double SmallGap = 2.0;
// A bend below this share of the angle between two planes leaves the plane's slope as it is.
constexpr double SlightBend = 0.25;
// The steepest slopes, as tangents of incidence, that two returns alone can show in a fine scan. In
// scans of several scenes, steeper ones were nearly all depth steps.
constexpr double SteepestToPlane = 18.0;
constexpr double SteepestFromPlane = 12.0;
constexpr double SteepestSmallCorner = 12.0;
constexpr double SteepestCorner = 8.0;
constexpr double SteepestSmallEdge = 8.0;
constexpr double SteepestEdge = 5.0;

double Square(double x)
{
  return x * x;
}
} // namespace

lms3dDepthStep::lms3dDepthStep(double depthStep, double degrees, double noise)
  : Absolute(depthStep)
  , Relative(std::max(MinimumRelative, std::abs(degrees) * lms3dRadiansPerDegree))
  , Flatness(std::clamp(FlatnessOfStep * depthStep, MinimumFlatness, MaximumFlatness))
  , Angle(std::abs(degrees) * lms3dRadiansPerDegree)
  , Variance(noise * noise)
  , AreNeighbors(std::abs(degrees) < MaximumStep)
{
  double sine, cosine;
  lms3dSinCosDegrees(degrees, sine, cosine);
  this->TwoCosines = 2.0 * cosine;
}

// Without branches, so that the compiler makes it a loop over vectors.
void lms3dDepthStep::FlagNear(
  const double* a, const double* b, int count, std::uint8_t flag, std::uint8_t* flags) const
{
  const double largest = this->AreNeighbors ? this->Absolute : -1.0;
  for (int i = 0; i < count; ++i)
  {
    const bool isNear = (a[i] > 0.0) & (b[i] > 0.0) & (std::abs(a[i] - b[i]) <= largest);
    flags[i] = static_cast<std::uint8_t>(flags[i] | (isNear ? flag : 0));
  }
}

void lms3dDepthStep::Plane::Add(const Plane& other, double weight)
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

// The plane that fits three returns best, if they are straight. The fit moves them in the ratio 1 : -2 : 1,
// which takes two thirds of the bend from the continuation. (For small angles between beams.)
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

lms3dDepthStep::Gap lms3dDepthStep::Measure(const Plane& plane, const Plane& other) const
{
  const double across = plane.Next - other.Inverse;
  const double noise = Deviations * std::sqrt(plane.VarianceOfNext + other.Variance);
  const double ofPlane = other.Inverse * std::max(plane.Next, 0.0);
  const double margin = this->Flatness * ofPlane + noise;
  const Gap::Place at =
    across > margin ? Gap::Before : (across < -margin ? Gap::Behind : Gap::AtReturn);
  const double size =
    ofPlane > 0.0 ? std::abs(across) / ofPlane : std::numeric_limits<double>::infinity();
  return { at, size, std::abs(across), noise > this->Absolute * Square(other.Inverse) };
}

lms3dDepthStep::Relation lms3dDepthStep::Classify(const Side& a, const Side& b) const
{
  if (!this->AreReturns(a.Ranges[0], b.Ranges[0]))
  {
    return Separate;
  }
  const Pair pair = this->Compare(this->GetPlane(a), this->GetPlane(b));
  const Relation relation = this->Classify(pair);
  if (relation != Uncertain)
  {
    return relation;
  }
  if (pair.AtFar.IsVague || pair.AtNear.IsVague)
  {
    return Noisy;
  }
  return this->IsTooSteep(pair) ? Separate : Uncertain;
}

lms3dDepthStep::Relation lms3dDepthStep::ClassifyMeans(const Plane& a, const Plane& b) const
{
  return this->Classify(this->Compare(a, b));
}

lms3dDepthStep::Pair lms3dDepthStep::Compare(const Plane& a, const Plane& b) const
{
  const bool isFirstNear = a.Inverse > b.Inverse;
  const Plane near = this->Fit(isFirstNear ? a : b);
  const Plane far = this->Fit(isFirstNear ? b : a);
  const double range = 1.0 / near.Inverse;
  return { near, far, this->Measure(near, far), this->Measure(far, near),
    this->Absolute + this->Relative * range, 1.0 / far.Inverse - range };
}

lms3dDepthStep::Relation lms3dDepthStep::Classify(const Pair& pair) const
{
  const Gap& atFar = pair.AtFar;
  const Gap& atNear = pair.AtNear;
  const bool areApart = (atFar.At == Gap::Before && atNear.At == Gap::Behind) ||
    (atFar.At == Gap::Behind && atNear.At == Gap::Before);
  if (areApart)
  {
    return std::max(atFar.Size, atNear.Size) > LargestGap * this->Absolute ||
        std::min(atFar.Size, atNear.Size) > pair.Tolerance
      ? Separate
      : Joined;
  }
  return pair.Difference <= pair.Tolerance ? Joined : this->ClassifyCrease(pair);
}

lms3dDepthStep::Relation lms3dDepthStep::ClassifyCrease(const Pair& pair) const
{
  const Gap& atFar = pair.AtFar;
  const Gap& atNear = pair.AtNear;
  const bool isNearStraight = this->IsStraight(pair.Near);
  const bool isFarStraight = this->IsStraight(pair.Far);
  bool isLikely = false;
  if (atFar.At == Gap::AtReturn && atNear.At == Gap::AtReturn)
  {
    return atFar.IsVague && atNear.IsVague ? Uncertain : Joined;
  }
  if (atFar.At == Gap::AtReturn)
  {
    isLikely = isNearStraight && !atFar.IsVague;
  }
  else if (atNear.At == Gap::AtReturn)
  {
    isLikely = isFarStraight && !atNear.IsVague;
  }
  else if (atFar.At == Gap::Behind)
  {
    isLikely = isNearStraight ||
      (pair.Near.HasBend && std::abs(pair.Near.Bend) <= SlightBend * atFar.InInverse);
  }
  else
  {
    isLikely = isFarStraight || (isNearStraight && atFar.Size <= pair.Tolerance);
  }
  return isLikely ? Likely : Uncertain;
}

// Whether a slope in a fine scan is steeper than slopes that two returns alone can show.
bool lms3dDepthStep::IsTooSteep(const Pair& pair) const
{
  const double range = 1.0 / pair.Near.Inverse;
  const double slope = pair.Difference / (range * this->Angle);
  const bool isSmall = std::min(pair.AtFar.Size, pair.AtNear.Size) <= SmallGap * this->Absolute;
  double steepest = isSmall ? SteepestSmallEdge : SteepestEdge;
  if (pair.AtFar.At == Gap::AtReturn)
  {
    steepest = SteepestToPlane;
  }
  else if (pair.AtNear.At == Gap::AtReturn)
  {
    steepest = SteepestFromPlane;
  }
  else if (pair.AtFar.At == Gap::Behind)
  {
    steepest = isSmall ? SteepestSmallCorner : SteepestCorner;
  }
  return this->Relative == MinimumRelative && slope > steepest;
}
