// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderRanges.h"

#include "LocalMap/Borders/lms3dSupportedChord.h"

#include <cmath>

namespace
{
using Gates = lms3dBorderGates;

// How many points of a cell are tried, and how far towards the returns.
constexpr int StepsInCell = 5;
constexpr double MaximumShareInCell = 0.5;

lms3dVector GetUnit(const lms3dVector& v)
{
  return lms3dScale(v, 1.0 / lms3dGetLength(v));
}

// Moves a point of a cell by a share of the way to the center of some of its corners.
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
  , Support(sphere, patches, gates)
{
}

lms3dVector lms3dBorderRanges::GetDirectionBeyond(int edge) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const GridIndex other = this->Gates.GetOwner(Gates::GetTwin(edge));
  return this->Gates.GetGate(edge).Kind == Gates::DepthStep
    ? this->Sphere.GetDirectionBeside(own, other)
    : this->Sphere.GetDirection(other);
}

lms3dVector lms3dBorderRanges::GetPointInGate(int edge, double at) const
{
  const lms3dVector own = this->Sphere.GetDirection(this->Gates.GetOwner(edge));
  const lms3dVector other = this->GetDirectionBeyond(edge);
  return lms3dAdd(lms3dScale(own, 1.0 - at), lms3dScale(other, at));
}

const lms3dPlane& lms3dBorderRanges::GetPlane(GridIndex index) const
{
  return this->Patches.Patches[this->Patches.Labels[index]].Plane;
}

double lms3dBorderRanges::GetExtension(int edge, double maximum) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const lms3dVector from = this->Sphere.GetDirection(own);
  const lms3dVector to = this->GetDirectionBeyond(edge);
  const lms3dPlane& plane = this->GetPlane(own);
  const double here = plane.GetInverseRange(from);
  const double there = plane.GetInverseRange(to);
  return lms3dSupportedChord{ here, there - here, lms3dDot(from, to), this->Sphere.GetRange(own),
    this->Support.GetMarginAtDepthStep(edge) }
    .FindEnd(maximum);
}

lms3dMapVertex lms3dBorderRanges::GetVertexInGate(int edge, double at) const
{
  const lms3dVector unit = GetUnit(this->GetPointInGate(edge, at));
  const double inverse = this->GetPlane(this->Gates.GetOwner(edge)).GetInverseRange(unit);
  switch (this->Gates.GetGate(edge).Kind)
  {
    case Gates::DepthStep:
      return { unit, this->Support.GetIntervalAtDepthStep(edge, unit).Clamp(inverse) };
    case Gates::Offset:
      return { unit, this->Support.GetIntervalAtOffset(edge, unit).Clamp(inverse) };
    default:
      return { unit, this->GetInverseAtCrease(edge, at, unit) };
  }
}

double lms3dBorderRanges::GetInverseAtCrease(int edge, double at, const lms3dVector& unit) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const GridIndex other = this->Gates.GetOwner(Gates::GetTwin(edge));
  const double here = this->GetPlane(own).GetInverseRange(unit);
  const double there = this->GetPlane(other).GetInverseRange(unit);
  if (!this->AreSameSurface(here, there))
  {
    return ((1.0 - at) / this->Sphere.GetRange(own) + at / this->Sphere.GetRange(other)) /
      lms3dGetLength(this->GetPointInGate(edge, at));
  }
  return this->Support.GetIntervalAtCrease(edge, unit).Clamp(0.5 * (here + there));
}

// Whether two inverse ranges differ by no more than the tolerance, as ranges do.
bool lms3dBorderRanges::AreSameSurface(double inverse, double other) const
{
  constexpr double Rounding = 1e-6;
  return inverse > 0.0 && other > 0.0 &&
    std::abs(inverse - other) <= (1.0 + Rounding) * this->Gates.GetTolerance() * inverse * other;
}

bool lms3dBorderRanges::HaveFewReturns(const Cell& cell, int corners) const
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

lms3dMapVertex lms3dBorderRanges::GetVertexInCell(
  const Cell& cell, int corners, const Weights& weights) const
{
  const bool isContinuous = this->Gates.IsContinuous(cell);
  CellPoint point = this->GetPointInCell(cell, corners, weights);
  if (isContinuous && !this->AreSameSurface(point.Minimum, point.Maximum) &&
    this->HaveFewReturns(cell, corners))
  {
    return { point.Unit, this->InterpolateInCell(cell, weights) };
  }
  lms3dRangeInterval interval =
    this->Support.GetIntervalInCell(cell, corners, isContinuous, point.Unit);
  // Beside a depth step, a vertex on the planes and nearer to the returns is better than one off
  // them.
  for (int step = 1; !isContinuous && step < StepsInCell && !interval.Contains(point.Best); ++step)
  {
    point = this->GetPointInCell(
      cell, corners, MoveTowards(corners, weights, MaximumShareInCell * step / (StepsInCell - 1)));
    interval = this->Support.GetIntervalInCell(cell, corners, isContinuous, point.Unit);
  }
  return { point.Unit, interval.Clamp(point.Best) };
}

// The direction of a corner. Beside a depth step, corners without the junction's patches count at
// the range of one with them.
lms3dVector lms3dBorderRanges::GetDirectionInCell(const Cell& cell, int corners, int corner) const
{
  if ((corners >> corner & 1) || this->Sphere.IsRegular() || this->Gates.IsContinuous(cell))
  {
    return this->Sphere.GetDirection(cell.Corners[corner]);
  }
  int own = 0;
  while (!(corners >> own & 1))
  {
    ++own;
  }
  return this->Sphere.GetDirectionBeside(cell.Corners[own], cell.Corners[corner]);
}

lms3dBorderRanges::CellPoint lms3dBorderRanges::GetPointInCell(
  const Cell& cell, int corners, const Weights& weights) const
{
  CellPoint point;
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    sum = lms3dAdd(sum, lms3dScale(this->GetDirectionInCell(cell, corners, i), weights[i]));
  }
  point.Unit = GetUnit(sum);
  std::array<std::int32_t, 4> labels = { -1, -1, -1, -1 };
  double total = 0.0;
  int count = 0;
  double most = 0.0;
  double inverseOfMost = 0.0;
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
      const double returns = this->Patches.Patches[label].Fit.GetNumberOfReturns();
      if (inverse > 0.0 && returns > most)
      {
        most = returns;
        inverseOfMost = inverse;
      }
    }
  }
  // Off the plane of a large patch, a vertex would pull large triangles away from their returns.
  const bool isBetween = most == 0.0 || this->AreSameSurface(point.Minimum, point.Maximum);
  point.Best = isBetween ? total / count : inverseOfMost;
  return point;
}

// The inverse range of the surface that runs straight from return to return.
double lms3dBorderRanges::InterpolateInCell(const Cell& cell, const Weights& weights) const
{
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  double inverse = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum = lms3dAdd(sum, lms3dScale(this->Sphere.GetDirection(cell.Corners[i]), weights[i]));
    inverse += weights[i] / this->Sphere.GetRange(cell.Corners[i]);
  }
  return inverse / lms3dGetLength(sum);
}
