// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <cmath>

namespace
{
// The share of the range's last change by which it may go on changing up to a border where more
// surface follows.
constexpr double ShareWithin = 0.6;
} // namespace

lms3dRangeInterval lms3dRangeSupport::GetIntervalAround(
  GridIndex index, double change, const lms3dVector& unit) const
{
  return GetInterval(this->Sphere.GetRange(index), change + this->Gates.GetTolerance(),
    lms3dDot(unit, this->Sphere.GetDirection(index)));
}

double lms3dRangeSupport::GetMarginAtDepthStep(int edge) const
{
  return this->Margins.GetMargin(this->Gates.GetOwner(edge), this->Gates.GetSide(edge));
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
    this->GetIntervalAround(own, ShareWithin * this->Margins.GetSlope(own, side), unit);
  interval.Include(this->GetIntervalAround(
    other, ShareWithin * this->Margins.GetSlope(other, (side + 2) % 4), unit));
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
  const double share = isContinuous ? ShareWithin : lms3dDepthStepMargins::ShareOfSlope;
  const bool isBesideMiss = std::any_of(cell.Corners.begin(), cell.Corners.end(),
    [&](GridIndex index) { return !this->Sphere.HasReturn(index); });
  const auto getSlope = [&](GridIndex index, int side)
  {
    const double slope = this->Margins.GetSlope(index, side);
    return isBesideMiss ? std::max(slope, this->Margins.GetSlopeOfPlane(index, side)) : slope;
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
