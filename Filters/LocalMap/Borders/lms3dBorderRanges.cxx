// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderRanges.h"

#include <cmath>

namespace
{
using Gates = lms3dBorderGates;
using GridIndex = lms3dBeamSphere::GridIndex;

// Of the last change of range before a border: what it may change by up to a border with nothing
// beyond, and up to one with more surface beyond.
constexpr double ShareAtDepthStep = 0.5;
constexpr double ShareWithin = 0.6;
// What of a depth step either side may take beyond that.
constexpr double ShareOfStep = 0.25;
// Of a return's range, what the surface beside it may come near the sensor to, however wide the bound.
constexpr double MinimumRangeShare = 0.1;
constexpr int BisectionSteps = 8;
// The same within a cell: how many places are tried, and how far towards the returns.
constexpr int StepsInCell = 5;
constexpr double ClosestInCell = 0.5;
// In cells nearly as wide as half a circle.
constexpr double MinimumCosine = 0.25;

lms3dVector Normalize(const lms3dVector& v)
{
  return lms3dScale(v, 1.0 / std::sqrt(lms3dDot(v, v)));
}

// From a point of a cell a share of the way to the middle of some of its corners.
lms3dBorderRanges::Weights MoveTowards(
  int corners, const lms3dBorderRanges::Weights& weights, double share)
{
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    count += corners >> i & 1;
  }
  lms3dBorderRanges::Weights moved;
  for (int i = 0; i < 4; ++i)
  {
    moved[i] = (1.0 - share) * weights[i] + ((corners >> i & 1) ? share / count : 0.0);
  }
  return moved;
}
} // namespace

lms3dBorderRanges::lms3dBorderRanges(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates)
  : Sphere(sphere)
  , Patches(patches)
  , Gates(gates)
{
}

lms3dVector lms3dBorderRanges::GetPointInGate(int edge, double at) const
{
  const lms3dVector own = this->Sphere.GetDirection(this->Gates.GetOwner(edge));
  const lms3dVector other = this->Sphere.GetDirection(this->Gates.GetOwner(Gates::GetTwin(edge)));
  return lms3dAdd(lms3dScale(own, 1.0 - at), lms3dScale(other, at));
}

const lms3dPatches::Patch& lms3dBorderRanges::GetPatch(GridIndex index) const
{
  return this->Patches.Patches[this->Patches.Labels[index]];
}

// How much the range changes from the return before a place to that of the place, towards a side; 0 where
// there is none of the patch.
double lms3dBorderRanges::GetSlope(GridIndex index, int side) const
{
  const int back = (side + 2) % 4;
  if (!this->HasSlope(index, back) || !this->Sphere.IsJoined(index, back))
  {
    return 0.0;
  }
  const GridIndex before = this->Sphere.GetNeighbor(index, back);
  return this->Patches.Labels[before] == this->Patches.Labels[index]
    ? std::abs(this->Sphere.GetRange(index) - this->Sphere.GetRange(before))
    : 0.0;
}

bool lms3dBorderRanges::HasSlope(GridIndex index, int back) const
{
  return this->Sphere.HasNeighbor(index, back) &&
    !this->Sphere.IsPoleRow(this->Sphere.GetRow(index));
}

// The same on the plane, where that rests on returns enough.
double lms3dBorderRanges::GetSlopeOfPlane(GridIndex index, int side) const
{
  const int back = (side + 2) % 4;
  if (!this->HasSlope(index, back) || this->Gates.HasFewReturns(this->Patches.Labels[index]))
  {
    return 0.0;
  }
  const double inverse = this->GetPatch(index).Plane.GetInverseRange(
    this->Sphere.GetDirection(this->Sphere.GetNeighbor(index, back)));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(index) - 1.0 / inverse) : 0.0;
}

// Around a range so many metres more or less, or on the plane through the return that faces the sensor:
// at a direction whose cosine to that of the return is given.
lms3dBorderRanges::Interval lms3dBorderRanges::GetInterval(
  double range, double margin, double cosine) const
{
  return { std::max(MinimumRangeShare * range, range - margin),
    range / std::max(MinimumCosine, cosine) + margin };
}

// Where the range changes by so much from a return on.
lms3dBorderRanges::Interval lms3dBorderRanges::GetInterval(
  GridIndex index, double change, const lms3dVector& unit) const
{
  return this->GetInterval(this->Sphere.GetRange(index), change + this->Gates.GetTolerance(),
    lms3dDot(unit, this->Sphere.GetDirection(index)));
}

// By how much the range may change from the last return before a cut to the border. Beside a miss nothing
// is near that the plane could meet. At a depth step, both sides together leave half of it open, however
// wide the bound.
double lms3dBorderRanges::GetMarginAtDepthStep(int edge) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const int side = this->Gates.GetSide(edge);
  const double other = this->Sphere.GetRange(this->Gates.GetOwner(Gates::GetTwin(edge)));
  if (other == 0.0)
  {
    const double slope = std::max(this->GetSlope(own, side), this->GetSlopeOfPlane(own, side));
    return ShareAtDepthStep * slope + this->Gates.GetTolerance();
  }
  const double step = std::abs(this->Sphere.GetRange(own) - other);
  return ShareAtDepthStep * this->GetSlope(own, side) +
    std::min(this->Gates.GetTolerance(), ShareOfStep * step);
}

double lms3dBorderRanges::GetExtension(int edge, double most) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const lms3dVector from = this->Sphere.GetDirection(own);
  const lms3dVector to = this->Sphere.GetDirection(this->Gates.GetOwner(Gates::GetTwin(edge)));
  const lms3dPlane& plane = this->GetPatch(own).Plane;
  const double here = plane.GetInverseRange(from);
  const double there = plane.GetInverseRange(to);
  const double cosine = lms3dDot(from, to);
  const double range = this->Sphere.GetRange(own);
  const double margin = this->GetMarginAtDepthStep(edge);
  const auto isWithin = [&](double at)
  {
    // Of the point so far along the chord.
    const double length = std::sqrt(1.0 - 2.0 * at * (1.0 - at) * (1.0 - cosine));
    return this->GetInterval(range, margin, (1.0 - at + at * cosine) / length)
      .Holds((here + at * (there - here)) / length);
  };
  if (isWithin(most))
  {
    return most;
  }
  double within = 0.0;
  double beyond = most;
  for (int step = 0; step < BisectionSteps; ++step)
  {
    const double middle = 0.5 * (within + beyond);
    (isWithin(middle) ? within : beyond) = middle;
  }
  return within;
}

lms3dMapVertex lms3dBorderRanges::GetVertexInGate(int edge, double at) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const GridIndex other = this->Gates.GetOwner(Gates::GetTwin(edge));
  const lms3dVector unit = Normalize(this->GetPointInGate(edge, at));
  const double inverse = this->GetPatch(own).Plane.GetInverseRange(unit);
  switch (this->Gates.GetGate(edge).Kind)
  {
    case Gates::DepthStep:
    {
      const double cosine = lms3dDot(unit, this->Sphere.GetDirection(own));
      const Interval interval =
        this->GetInterval(this->Sphere.GetRange(own), this->GetMarginAtDepthStep(edge), cosine);
      return { unit, interval.Clamp(inverse) };
    }
    case Gates::Offset:
    {
      Interval interval = this->GetInterval(own, 0.0, unit);
      interval.Include(this->GetInterval(other, 0.0, unit));
      return { unit, interval.Clamp(inverse) };
    }
    default:
      return { unit, this->GetInverseAtCrease(edge, at, unit) };
  }
}

// Where the planes meet or, between patches of few returns, straight from return to return.
double lms3dBorderRanges::GetInverseAtCrease(int edge, double at, const lms3dVector& unit) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const GridIndex other = this->Gates.GetOwner(Gates::GetTwin(edge));
  const double here = this->GetPatch(own).Plane.GetInverseRange(unit);
  const double there = this->GetPatch(other).Plane.GetInverseRange(unit);
  if (!this->AreSameSurface(here, there))
  {
    const lms3dVector point = this->GetPointInGate(edge, at);
    return ((1.0 - at) / this->Sphere.GetRange(own) + at / this->Sphere.GetRange(other)) /
      std::sqrt(lms3dDot(point, point));
  }
  const int side = this->Gates.GetSide(edge);
  Interval interval = this->GetInterval(own, ShareWithin * this->GetSlope(own, side), unit);
  interval.Include(
    this->GetInterval(other, ShareWithin * this->GetSlope(other, (side + 2) % 4), unit));
  return interval.Clamp(0.5 * (here + there));
}

// Whether two inverse ranges mean the same surface.
bool lms3dBorderRanges::AreSameSurface(double inverse, double other) const
{
  constexpr double Rounding = 1e-6;
  return inverse > 0.0 && other > 0.0 &&
    std::abs(inverse - other) <= (1.0 + Rounding) * this->Gates.GetTolerance() * inverse * other;
}

bool lms3dBorderRanges::HaveFewReturns(const Gates::Cell& cell, int corners) const
{
  for (int i = 0; i < 4; ++i)
  {
    if ((corners >> i & 1) && !this->Gates.HasFewReturns(this->Patches.Labels[cell.Corners[i]]))
    {
      return false;
    }
  }
  return true;
}

bool lms3dBorderRanges::IsContinuous(const Gates::Cell& cell) const
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const int gate = this->Gates.GetCellGate(cell, corner);
    if (this->Patches.Labels[cell.Corners[corner]] < 0 ||
      (gate != Gates::NoGate && this->Gates.GetGate(2 * gate).Kind == Gates::DepthStep))
    {
      return false;
    }
  }
  return true;
}

lms3dMapVertex lms3dBorderRanges::GetVertexInCell(
  const Gates::Cell& cell, int corners, const Weights& weights) const
{
  const bool isContinuous = this->IsContinuous(cell);
  CellPoint point = this->GetPointInCell(cell, corners, weights);
  if (isContinuous && !this->AreSameSurface(point.Minimum, point.Maximum) &&
    this->HaveFewReturns(cell, corners))
  {
    return { point.Unit, this->GetStraightInCell(cell, weights) };
  }
  Interval interval = this->GetIntervalInCell(cell, corners, isContinuous, point.Unit);
  // Beside a cut, rather nearer to the returns than off their planes.
  for (int step = 1; !isContinuous && step < StepsInCell && !interval.Holds(point.Mean); ++step)
  {
    point = this->GetPointInCell(
      cell, corners, MoveTowards(corners, weights, ClosestInCell * step / (StepsInCell - 1)));
    interval = this->GetIntervalInCell(cell, corners, isContinuous, point.Unit);
  }
  return { point.Unit, interval.Clamp(point.Mean) };
}

// What the planes of the corners' patches say of a point.
lms3dBorderRanges::CellPoint lms3dBorderRanges::GetPointInCell(
  const Gates::Cell& cell, int corners, const Weights& weights) const
{
  CellPoint point;
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    sum = lms3dAdd(sum, lms3dScale(this->Sphere.GetDirection(cell.Corners[i]), weights[i]));
  }
  point.Unit = Normalize(sum);
  std::array<std::int32_t, 4> labels = { -1, -1, -1, -1 };
  double total = 0.0;
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    const std::int32_t label = this->Patches.Labels[cell.Corners[i]];
    if ((corners >> i & 1) && std::find(labels.begin(), labels.end(), label) == labels.end())
    {
      labels[i] = label;
      const double inverse = this->Patches.Patches[label].Plane.GetInverseRange(point.Unit);
      point.Minimum = std::min(point.Minimum, inverse);
      point.Maximum = std::max(point.Maximum, inverse);
      total += inverse;
      ++count;
    }
  }
  point.Mean = total / count;
  return point;
}

// Where the surface runs from return to return.
double lms3dBorderRanges::GetStraightInCell(const Gates::Cell& cell, const Weights& weights) const
{
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  double inverse = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum = lms3dAdd(sum, lms3dScale(this->Sphere.GetDirection(cell.Corners[i]), weights[i]));
    inverse += weights[i] / this->Sphere.GetRange(cell.Corners[i]);
  }
  return inverse / std::sqrt(lms3dDot(sum, sum));
}

lms3dBorderRanges::Interval lms3dBorderRanges::GetIntervalInCell(
  const Gates::Cell& cell, int corners, bool isContinuous, const lms3dVector& unit) const
{
  // From each corner of a cell, clockwise from the lower left one, into it.
  constexpr int Into[4][2] = { { lms3dBeamSphere::Up, lms3dBeamSphere::Right },
    { lms3dBeamSphere::Right, lms3dBeamSphere::Down },
    { lms3dBeamSphere::Down, lms3dBeamSphere::Left },
    { lms3dBeamSphere::Left, lms3dBeamSphere::Up } };
  const double share = isContinuous ? ShareWithin : ShareAtDepthStep;
  const bool isBesideMiss = std::any_of(cell.Corners.begin(), cell.Corners.end(),
    [&](GridIndex index) { return !this->Sphere.HasReturn(index); });
  const auto getSlope = [&](GridIndex index, int side)
  {
    const double slope = this->GetSlope(index, side);
    return isBesideMiss ? std::max(slope, this->GetSlopeOfPlane(index, side)) : slope;
  };
  Interval interval;
  for (int i = 0; i < 4; ++i)
  {
    if (corners >> i & 1)
    {
      const GridIndex index = cell.Corners[i];
      const double change = share * (getSlope(index, Into[i][0]) + getSlope(index, Into[i][1]));
      interval.Include(this->GetInterval(index, change, unit));
    }
  }
  return interval;
}
