// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dDepthStepMargins.h"

#include <algorithm>
#include <cmath>

namespace
{
// The share of a depth step that either side may take.
constexpr double ShareOfStep = 0.25;
} // namespace

double lms3dDepthStepMargins::GetMargin(GridIndex own, int side) const
{
  const double other = this->Sphere.GetRange(this->Sphere.GetNeighbor(own, side));
  if (other == 0.0)
  {
    const double slope = std::max(this->GetSlope(own, side), this->GetSlopeOfPlane(own, side));
    return ShareOfSlope * slope + this->Tolerance;
  }
  const double step = std::abs(this->Sphere.GetRange(own) - other);
  return ShareOfSlope * this->GetSlope(own, side) + std::min(this->Tolerance, ShareOfStep * step);
}

double lms3dDepthStepMargins::GetSlope(GridIndex index, int side) const
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

bool lms3dDepthStepMargins::HasSlope(GridIndex index, int back) const
{
  return this->Sphere.HasNeighbor(index, back) &&
    !this->Sphere.IsPoleRow(this->Sphere.GetRow(index));
}

double lms3dDepthStepMargins::GetSlopeOfPlane(GridIndex index, int side) const
{
  const int back = (side + 2) % 4;
  const std::int32_t patch = this->Patches.Labels[index];
  if (!this->HasSlope(index, back) || this->Patches.HasFewReturns(patch))
  {
    return 0.0;
  }
  const double inverse = this->Patches.Patches[patch].Plane.GetInverseRange(
    this->Sphere.GetDirection(this->Sphere.GetNeighbor(index, back)));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(index) - 1.0 / inverse) : 0.0;
}
