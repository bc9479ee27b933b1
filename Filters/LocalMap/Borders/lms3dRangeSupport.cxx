// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <cmath>

namespace
{
// The shares of the range's last change by which it may go on changing up to a border: at a depth step,
// and where more surface follows beyond the border.
constexpr double ShareAtDepthStep = 0.5;
constexpr double ShareWithin = 0.6;
// The share of a depth step that either side may take beyond that.
constexpr double ShareOfStep = 0.25;
// The surface beside a return never comes nearer to the sensor than this share of the return's range.
constexpr double MinimumRangeShare = 0.1;
// Limits the far end in cells that are nearly as wide as half a circle.
constexpr double MinimumCosine = 0.25;
} // namespace

// The change of range from the neighbour behind a return to the return, along the way to a side. 0 if
// the neighbour is not joined or not in the patch.
double lms3dRangeSupport::GetSlope(GridIndex index, int side) const
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

bool lms3dRangeSupport::HasSlope(GridIndex index, int back) const
{
  return this->Sphere.HasNeighbor(index, back) &&
    !this->Sphere.IsPoleRow(this->Sphere.GetRow(index));
}

// The same change as the patch's plane predicts it. 0 if the plane rests on few returns.
double lms3dRangeSupport::GetSlopeOfPlane(GridIndex index, int side) const
{
  const int back = (side + 2) % 4;
  const std::int32_t patch = this->Patches.Labels[index];
  if (!this->HasSlope(index, back) || this->Gates.HasFewReturns(patch))
  {
    return 0.0;
  }
  const double inverse = this->Patches.Patches[patch].Plane.GetInverseRange(
    this->Sphere.GetDirection(this->Sphere.GetNeighbor(index, back)));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(index) - 1.0 / inverse) : 0.0;
}

lms3dRangeInterval lms3dRangeSupport::GetInterval(double range, double margin, double cosine)
{
  return { std::max(MinimumRangeShare * range, range - margin),
    range / std::max(MinimumCosine, cosine) + margin };
}

lms3dRangeInterval lms3dRangeSupport::GetIntervalAround(
  GridIndex index, double change, const lms3dVector& unit) const
{
  return GetInterval(this->Sphere.GetRange(index), change + this->Gates.GetTolerance(),
    lms3dDot(unit, this->Sphere.GetDirection(index)));
}

double lms3dRangeSupport::GetMarginAtDepthStep(int edge) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const int side = this->Gates.GetSide(edge);
  const double other = this->Sphere.GetRange(this->Gates.GetOwner(lms3dBorderGates::GetTwin(edge)));
  if (other == 0.0)
  {
    const double slope = std::max(this->GetSlope(own, side), this->GetSlopeOfPlane(own, side));
    return ShareAtDepthStep * slope + this->Gates.GetTolerance();
  }
  const double step = std::abs(this->Sphere.GetRange(own) - other);
  return ShareAtDepthStep * this->GetSlope(own, side) +
    std::min(this->Gates.GetTolerance(), ShareOfStep * step);
}

lms3dRangeInterval lms3dRangeSupport::GetIntervalAtDepthStep(
  int edge, const lms3dVector& unit) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  return GetInterval(this->Sphere.GetRange(own), this->GetMarginAtDepthStep(edge),
    lms3dDot(unit, this->Sphere.GetDirection(own)));
}

lms3dRangeInterval lms3dRangeSupport::GetIntervalAtCrease(int edge, const lms3dVector& unit) const
{
  const GridIndex own = this->Gates.GetOwner(edge);
  const GridIndex other = this->Gates.GetOwner(lms3dBorderGates::GetTwin(edge));
  const int side = this->Gates.GetSide(edge);
  lms3dRangeInterval interval =
    this->GetIntervalAround(own, ShareWithin * this->GetSlope(own, side), unit);
  interval.Include(
    this->GetIntervalAround(other, ShareWithin * this->GetSlope(other, (side + 2) % 4), unit));
  return interval;
}

lms3dRangeInterval lms3dRangeSupport::GetIntervalAtOffset(int edge, const lms3dVector& unit) const
{
  lms3dRangeInterval interval = this->GetIntervalAround(this->Gates.GetOwner(edge), 0.0, unit);
  interval.Include(
    this->GetIntervalAround(this->Gates.GetOwner(lms3dBorderGates::GetTwin(edge)), 0.0, unit));
  return interval;
}

lms3dRangeInterval lms3dRangeSupport::GetIntervalInCell(
  const Cell& cell, int corners, bool isContinuous, const lms3dVector& unit) const
{
  // The two sides of each corner that lead into the cell.
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
  lms3dRangeInterval interval;
  for (int i = 0; i < 4; ++i)
  {
    if (corners >> i & 1)
    {
      const GridIndex index = cell.Corners[i];
      const double change = share * (getSlope(index, Into[i][0]) + getSlope(index, Into[i][1]));
      interval.Include(this->GetIntervalAround(index, change, unit));
    }
  }
  return interval;
}
