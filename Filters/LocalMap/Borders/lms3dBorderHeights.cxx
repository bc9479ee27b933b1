// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderHeights.h"

#include <cmath>

namespace
{
using Gates = lms3dBorderGates;
using Place = lms3dBeamSphere::Place;

// Of the last change of range before a border: what it may change by up to a border with nothing
// beyond, and up to one with more surface beyond.
constexpr double ShareAtCut = 0.5;
constexpr double ShareWithin = 0.6;
// What of a depth step either side may take beyond that.
constexpr double ShareOfStep = 0.25;
// Of a return's range, what the surface beside it may come near the sensor to, however wide the bound.
constexpr double NearestShare = 0.1;
constexpr int StepsOfReach = 8;
// The same within a cell: how many places are tried, and how far towards the returns.
constexpr int StepsInCell = 5;
constexpr double ClosestInCell = 0.5;
// In cells nearly as wide as half a circle.
constexpr double SmallestCosine = 0.25;

lms3dVector Normalize(const lms3dVector& v)
{
  return lms3dScale(v, 1.0 / std::sqrt(lms3dDot(v, v)));
}

// From a point of a cell a share of the way to the middle of some of its corners.
lms3dBorderHeights::Weights MoveTowards(
  int corners, const lms3dBorderHeights::Weights& weights, double share)
{
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    count += corners >> i & 1;
  }
  lms3dBorderHeights::Weights moved;
  for (int i = 0; i < 4; ++i)
  {
    moved[i] = (1.0 - share) * weights[i] + ((corners >> i & 1) ? share / count : 0.0);
  }
  return moved;
}
} // namespace

lms3dBorderHeights::lms3dBorderHeights(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates)
  : Sphere(sphere)
  , Patches(patches)
  , Gates(gates)
{
}

lms3dVector lms3dBorderHeights::GetPointInGate(int edge, double at) const
{
  const lms3dVector own = this->Sphere.GetDirection(this->Gates.GetOwner(edge));
  const lms3dVector other = this->Sphere.GetDirection(this->Gates.GetOwner(Gates::GetTwin(edge)));
  return lms3dAdd(lms3dScale(own, 1.0 - at), lms3dScale(other, at));
}

const lms3dPatches::Patch& lms3dBorderHeights::GetPatch(Place place) const
{
  return this->Patches.Patches[this->Patches.Labels[place]];
}

// How much the range changes from the return before a place to that of the place, towards a side; 0 where
// there is none of the patch.
double lms3dBorderHeights::GetSlope(Place place, int side) const
{
  const int back = (side + 2) % 4;
  if (!this->HasSlope(place, back) || !this->Sphere.IsJoined(place, back))
  {
    return 0.0;
  }
  const Place before = this->Sphere.GetNeighbor(place, back);
  return this->Patches.Labels[before] == this->Patches.Labels[place]
    ? std::abs(this->Sphere.GetRange(place) - this->Sphere.GetRange(before))
    : 0.0;
}

bool lms3dBorderHeights::HasSlope(Place place, int back) const
{
  return this->Sphere.HasNeighbor(place, back) &&
    !this->Sphere.IsPoleRow(this->Sphere.GetRow(place));
}

// The same on the plane, where that rests on returns enough.
double lms3dBorderHeights::GetSlopeOfPlane(Place place, int side) const
{
  const int back = (side + 2) % 4;
  if (!this->HasSlope(place, back) || this->Gates.IsFew(this->Patches.Labels[place]))
  {
    return 0.0;
  }
  const double inverse = this->GetPatch(place).Plane.GetInverseRange(
    this->Sphere.GetDirection(this->Sphere.GetNeighbor(place, back)));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(place) - 1.0 / inverse) : 0.0;
}

// Around a range so many metres more or less, or on the plane through the return that faces the sensor:
// at a direction whose cosine to that of the return is given.
lms3dBorderHeights::Interval lms3dBorderHeights::GetInterval(
  double range, double margin, double cosine) const
{
  return { std::max(NearestShare * range, range - margin),
    range / std::max(SmallestCosine, cosine) + margin };
}

// Where the range changes by so much from a return on.
lms3dBorderHeights::Interval lms3dBorderHeights::GetInterval(
  Place place, double change, const lms3dVector& unit) const
{
  return this->GetInterval(this->Sphere.GetRange(place), change + this->Gates.GetTolerance(),
    lms3dDot(unit, this->Sphere.GetDirection(place)));
}

// By how much the range may change from the last return before a cut to the border. Beside a miss nothing
// is near that the plane could meet. At a depth step, both sides together leave half of it open, however
// wide the bound.
double lms3dBorderHeights::GetMarginAtCut(int edge) const
{
  const Place own = this->Gates.GetOwner(edge);
  const int side = this->Gates.GetSide(edge);
  const double other = this->Sphere.GetRange(this->Gates.GetOwner(Gates::GetTwin(edge)));
  if (other == 0.0)
  {
    const double slope = std::max(this->GetSlope(own, side), this->GetSlopeOfPlane(own, side));
    return ShareAtCut * slope + this->Gates.GetTolerance();
  }
  const double step = std::abs(this->Sphere.GetRange(own) - other);
  return ShareAtCut * this->GetSlope(own, side) +
    std::min(this->Gates.GetTolerance(), ShareOfStep * step);
}

double lms3dBorderHeights::GetReach(int edge, double most) const
{
  const Place own = this->Gates.GetOwner(edge);
  const lms3dVector from = this->Sphere.GetDirection(own);
  const lms3dVector to = this->Sphere.GetDirection(this->Gates.GetOwner(Gates::GetTwin(edge)));
  const lms3dPlane& plane = this->GetPatch(own).Plane;
  const double here = plane.GetInverseRange(from);
  const double there = plane.GetInverseRange(to);
  const double cosine = lms3dDot(from, to);
  const double range = this->Sphere.GetRange(own);
  const double margin = this->GetMarginAtCut(edge);
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
  for (int step = 0; step < StepsOfReach; ++step)
  {
    const double middle = 0.5 * (within + beyond);
    (isWithin(middle) ? within : beyond) = middle;
  }
  return within;
}

lms3dMapVertex lms3dBorderHeights::GetVertexInGate(int edge, double at) const
{
  const Place own = this->Gates.GetOwner(edge);
  const Place other = this->Gates.GetOwner(Gates::GetTwin(edge));
  const lms3dVector unit = Normalize(this->GetPointInGate(edge, at));
  const double inverse = this->GetPatch(own).Plane.GetInverseRange(unit);
  switch (this->Gates.GetGate(edge).Is)
  {
    case Gates::Cut:
    {
      const double cosine = lms3dDot(unit, this->Sphere.GetDirection(own));
      const Interval interval =
        this->GetInterval(this->Sphere.GetRange(own), this->GetMarginAtCut(edge), cosine);
      return { unit, interval.Clamp(inverse) };
    }
    case Gates::Step:
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
double lms3dBorderHeights::GetInverseAtCrease(int edge, double at, const lms3dVector& unit) const
{
  const Place own = this->Gates.GetOwner(edge);
  const Place other = this->Gates.GetOwner(Gates::GetTwin(edge));
  const double here = this->GetPatch(own).Plane.GetInverseRange(unit);
  const double there = this->GetPatch(other).Plane.GetInverseRange(unit);
  if (!this->AreOne(here, there))
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
bool lms3dBorderHeights::AreOne(double inverse, double other) const
{
  constexpr double Rounding = 1e-6;
  return inverse > 0.0 && other > 0.0 &&
    std::abs(inverse - other) <= (1.0 + Rounding) * this->Gates.GetTolerance() * inverse * other;
}

bool lms3dBorderHeights::AreFew(const Gates::Cell& cell, int corners) const
{
  for (int i = 0; i < 4; ++i)
  {
    if ((corners >> i & 1) && !this->Gates.IsFew(this->Patches.Labels[cell.Corners[i]]))
    {
      return false;
    }
  }
  return true;
}

bool lms3dBorderHeights::IsWhole(const Gates::Cell& cell) const
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const int gate = this->Gates.GetCellGate(cell, corner);
    if (this->Patches.Labels[cell.Corners[corner]] < 0 ||
      (gate != Gates::NoGate && this->Gates.GetGate(2 * gate).Is == Gates::Cut))
    {
      return false;
    }
  }
  return true;
}

lms3dMapVertex lms3dBorderHeights::GetVertexInCell(
  const Gates::Cell& cell, int corners, const Weights& weights) const
{
  const bool isWhole = this->IsWhole(cell);
  CellPoint point = this->GetPointInCell(cell, corners, weights);
  if (isWhole && !this->AreOne(point.Least, point.Most) && this->AreFew(cell, corners))
  {
    return { point.Unit, this->GetStraightInCell(cell, weights) };
  }
  Interval interval = this->GetIntervalInCell(cell, corners, isWhole, point.Unit);
  // Beside a cut, rather nearer to the returns than off their planes.
  for (int step = 1; !isWhole && step < StepsInCell && !interval.Holds(point.Mean); ++step)
  {
    point = this->GetPointInCell(
      cell, corners, MoveTowards(corners, weights, ClosestInCell * step / (StepsInCell - 1)));
    interval = this->GetIntervalInCell(cell, corners, isWhole, point.Unit);
  }
  return { point.Unit, interval.Clamp(point.Mean) };
}

// What the planes of the corners' patches say of a point.
lms3dBorderHeights::CellPoint lms3dBorderHeights::GetPointInCell(
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
      point.Least = std::min(point.Least, inverse);
      point.Most = std::max(point.Most, inverse);
      total += inverse;
      ++count;
    }
  }
  point.Mean = total / count;
  return point;
}

// Where the surface runs from return to return.
double lms3dBorderHeights::GetStraightInCell(const Gates::Cell& cell, const Weights& weights) const
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

lms3dBorderHeights::Interval lms3dBorderHeights::GetIntervalInCell(
  const Gates::Cell& cell, int corners, bool isWhole, const lms3dVector& unit) const
{
  // From each corner of a cell, clockwise from the lower left one, into it.
  constexpr int Into[4][2] = { { lms3dBeamSphere::Up, lms3dBeamSphere::Right },
    { lms3dBeamSphere::Right, lms3dBeamSphere::Down },
    { lms3dBeamSphere::Down, lms3dBeamSphere::Left },
    { lms3dBeamSphere::Left, lms3dBeamSphere::Up } };
  const double share = isWhole ? ShareWithin : ShareAtCut;
  const bool isBesideMiss = std::any_of(cell.Corners.begin(), cell.Corners.end(),
    [&](Place place) { return !this->Sphere.HasReturn(place); });
  const auto getSlope = [&](Place place, int side)
  {
    const double slope = this->GetSlope(place, side);
    return isBesideMiss ? std::max(slope, this->GetSlopeOfPlane(place, side)) : slope;
  };
  Interval interval;
  for (int i = 0; i < 4; ++i)
  {
    if (corners >> i & 1)
    {
      const Place place = cell.Corners[i];
      const double change = share * (getSlope(place, Into[i][0]) + getSlope(place, Into[i][1]));
      interval.Include(this->GetInterval(place, change, unit));
    }
  }
  return interval;
}
