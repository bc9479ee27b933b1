// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dDepthStep.h"

#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dWideLoops.h"
#include "LocalMap/Grid/lms3dSlopeLimits.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double MaximumStep = 180.0;
// Real surfaces bend by this distance from a plane, metres: at most, as a share of the depth step,
// and at least.
constexpr double MaximumFlatness = 0.02;
constexpr double FlatnessOfStep = 0.2;
constexpr double MinimumFlatness = 0.001;
// The largest gap, in depth steps, that is not separated where neither plane meets the other
// return.
constexpr double LargestGap = 1.8;
// Two planes that both miss the other return by more than a depth step are separate if the ranges
// differ by more than this number of depth steps. For smaller differences the other rules decide,
// which leave gentle slopes whole.
constexpr double PlanesDifference = 1.5;
// The gaps of such planes must exceed this number of flatnesses as well: the ground bends. (From a
// depth step of 5 mm on, this is at most the depth step.)
constexpr double FlatnessesOfGap = 5.0;
// A crease is small if a gap beside it has at most this number of depth steps.
constexpr double SmallGap = 2.0;
// The tolerance, in depth steps, above which returns can be Loose or Gentle: the beams are far
// apart.
constexpr double SmallestTolerance = 6.0;
// What makes returns within the tolerance Loose, in depth steps: how much their ranges differ, and
// both gaps. (Gaps that bends of real surfaces leave do not count.)
constexpr double LooseDifference = 2.0;
constexpr double LooseGap = 5.0;
constexpr double SmallestLooseGap = 0.5;
// The largest tolerance at which returns can be Gentle, in depth steps. If the user wants to see
// steps that are far smaller than the tolerance, they stay.
constexpr double GentleTolerance = 30.0;
// A bend below this share of the angle between two planes leaves the plane's slope as it is.
constexpr double SlightBend = 0.25;
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
LMS3D_WIDE_LOOPS
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
  // Vague if the range within the noise ends more than a depth step behind the return.
  const double ofStep = this->Absolute * other.Inverse * std::max(other.Inverse - noise, 0.0);
  return { at, size, std::abs(across), noise > ofStep };
}

lms3dDepthStep::Relation lms3dDepthStep::Classify(const Side& a, const Side& b) const
{
  return this->AreReturns(a.Ranges[0], b.Ranges[0])
    ? this->ClassifyAlone(this->Compare(this->GetPlane(a), this->GetPlane(b)))
    : Separate;
}

// Along a fan, a gentle slope behind a curve is the same surface. (Along turns, the side of a hill
// can end there in front of another hill.)
lms3dDepthStep::Relation lms3dDepthStep::ClassifyInFan(const double* at) const
{
  if (!this->AreReturns(at[0], at[1]))
  {
    return Separate;
  }
  const Pair pair =
    this->Compare(this->GetPlane(GetSideBefore(at)), this->GetPlane(GetSideBehind(at)));
  const Relation relation = this->ClassifyAlone(pair);
  const bool areOverlapping =
    (relation == Separate || relation == Gentle) && pair.AtFar.At == Gap::Behind;
  return (areOverlapping || relation == Uncertain) && this->IsCurved(pair.Near) &&
      this->IsGentle(pair, lms3dSlopeLimits::GentleInFan)
    ? Likely
    : relation;
}

lms3dDepthStep::Relation lms3dDepthStep::ClassifyAlone(const Pair& pair) const
{
  const Relation relation = this->Classify(pair);
  if (relation != Uncertain)
  {
    return relation;
  }
  if (pair.AtFar.IsVague || pair.AtNear.IsVague)
  {
    return Noisy;
  }
  const bool isMet = pair.AtFar.At == Gap::AtReturn || pair.AtNear.At == Gap::AtReturn;
  if (isMet && this->IsGentle(pair, lms3dSlopeLimits::GentleToPlane))
  {
    return Likely;
  }
  return this->IsTooSteep(pair) ? Separate : Uncertain;
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
  const Relation relation = areApart    ? this->ClassifyApart(pair)
    : pair.Difference <= pair.Tolerance ? Joined
                                        : this->ClassifyCrease(pair);
  return relation == Joined && this->IsLoose(pair) ? Loose : relation;
}

// Where the planes do not intersect between the beams.
lms3dDepthStep::Relation lms3dDepthStep::ClassifyApart(const Pair& pair) const
{
  const auto [smaller, larger] = std::minmax(pair.AtFar.Size, pair.AtNear.Size);
  if (pair.Difference > PlanesDifference * this->Absolute &&
    smaller > std::max(this->Absolute, FlatnessesOfGap * this->Flatness) &&
    this->IsStraight(pair.Near) && this->IsStraight(pair.Far))
  {
    return Separate;
  }
  const bool isStep = larger > LargestGap * this->Absolute || smaller > pair.Tolerance;
  if (!isStep || this->IsGentleBetween(pair))
  {
    return Joined;
  }
  const bool isGentle = pair.Tolerance > SmallestTolerance * this->Absolute &&
    pair.Tolerance <= GentleTolerance * this->Absolute &&
    this->Angle <= lms3dSlopeLimits::WidestGentle &&
    this->GetSlope(pair) <= lms3dSlopeLimits::GentleWhole;
  return isGentle ? Gentle : Separate;
}

bool lms3dDepthStep::IsLoose(const Pair& pair) const
{
  const auto [smaller, larger] = std::minmax(pair.AtFar.Size, pair.AtNear.Size);
  return pair.Difference <= pair.Tolerance && pair.Difference > LooseDifference * this->Absolute &&
    pair.Tolerance > SmallestTolerance * this->Absolute && larger > LooseGap * this->Absolute &&
    smaller > std::max(SmallestLooseGap * this->Absolute, this->Flatness);
}

lms3dDepthStep::Relation lms3dDepthStep::ClassifyCrease(const Pair& pair) const
{
  const Gap& atFar = pair.AtFar;
  const Gap& atNear = pair.AtNear;
  const bool isNearStraight = this->IsStraight(pair.Near);
  const bool isFarStraight = this->IsStraight(pair.Far);
  const Relation crease = this->Relative == MinimumRelative ? Crease : Likely;
  if (atFar.At == Gap::AtReturn && atNear.At == Gap::AtReturn)
  {
    return atFar.IsVague && atNear.IsVague ? Uncertain : Joined;
  }
  if (atFar.At == Gap::AtReturn)
  {
    return isNearStraight && !atFar.IsVague ? Likely : Uncertain;
  }
  if (atNear.At == Gap::AtReturn)
  {
    return isFarStraight && !atNear.IsVague ? Likely : Uncertain;
  }
  if (atFar.At == Gap::Behind)
  {
    const bool isCrease = isNearStraight ||
      (pair.Near.HasBend && std::abs(pair.Near.Bend) <= SlightBend * atFar.InInverse);
    return isCrease ? crease : Uncertain;
  }
  if (isFarStraight)
  {
    return Likely;
  }
  return isNearStraight && atFar.Size <= pair.Tolerance ? crease : Uncertain;
}

// Whether the slope between planes that do not intersect is gentle enough for one surface.
bool lms3dDepthStep::IsGentleBetween(const Pair& pair) const
{
  const bool areOverlapping = pair.AtFar.At == Gap::Behind;
  const bool areCurved = this->IsCurved(pair.Near) && this->IsCurved(pair.Far) &&
    std::min(pair.AtFar.Size, pair.AtNear.Size) <= pair.Tolerance;
  return (areOverlapping && this->IsGentle(pair, lms3dSlopeLimits::GentleOverlap)) ||
    ((areOverlapping || areCurved) && this->Angle <= lms3dSlopeLimits::WidestGentle &&
      this->GetSlope(pair) <= lms3dSlopeLimits::GentleCurve);
}

// Whether a slope in a fine scan is steeper than slopes that two returns alone can show.
bool lms3dDepthStep::IsTooSteep(const Pair& pair) const
{
  namespace Limits = lms3dSlopeLimits;
  const bool isSmall = std::min(pair.AtFar.Size, pair.AtNear.Size) <= SmallGap * this->Absolute;
  double steepest = isSmall ? Limits::SteepestSmallEdge : Limits::SteepestEdge;
  if (pair.AtFar.At == Gap::AtReturn)
  {
    steepest = Limits::SteepestToPlane;
  }
  else if (pair.AtNear.At == Gap::AtReturn)
  {
    steepest = Limits::SteepestFromPlane;
  }
  else if (pair.AtFar.At == Gap::Behind)
  {
    steepest = isSmall ? Limits::SteepestSmallCorner : Limits::SteepestCorner;
  }
  return this->Relative == MinimumRelative && this->GetSlope(pair) > steepest;
}
