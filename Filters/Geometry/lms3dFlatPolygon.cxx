// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dFlatPolygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Does not underflow for areas of tiny polygons, unlike the root of a sum of squares.
double GetLength(const lms3dVector& v)
{
  const double scale = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  if (scale == 0.0)
  {
    return 0.0;
  }
  const lms3dVector unit = { v[0] / scale, v[1] / scale, v[2] / scale };
  return scale * std::sqrt(lms3dDot(unit, unit));
}

lms3dVector GetFanNormal(const std::vector<lms3dVector>& corners, std::size_t i)
{
  return lms3dCross(
    lms3dSubtract(corners[i], corners[0]), lms3dSubtract(corners[i + 1], corners[0]));
}

// Newell's normal is the sum over a fan. The sum can vanish for a polygon that crosses itself. Then
// the normal of the largest triangle of the fan takes its place.
lms3dVector GetNormal(const std::vector<lms3dVector>& corners)
{
  lms3dVector sum = { 0, 0, 0 };
  lms3dVector largest = { 0, 0, 0 };
  double largestLength = 0.0;
  double total = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const lms3dVector normal = GetFanNormal(corners, i);
    const double length = GetLength(normal);
    total += length;
    largest = length > largestLength ? normal : largest;
    largestLength = std::max(length, largestLength);
    sum = lms3dAdd(sum, normal);
  }
  constexpr double rounding = 1e-12;
  return GetLength(sum) > rounding * total ? sum : largest;
}

// The corners on a straight line that is not parallel to an axis deviate from it by rounding.
double GetRounding(const std::vector<lms3dVector>& corners, int first, int second)
{
  constexpr double rounding = 1e-14;
  double farthest = 0.0;
  for (const lms3dVector& corner : corners)
  {
    farthest = std::max({ farthest, std::abs(corner[first]), std::abs(corner[second]) });
  }
  return rounding * farthest;
}
} // namespace

// Drops the axis that the normal is nearest to.
bool lms3dFlatPolygon::Project(const std::vector<lms3dVector>& corners)
{
  const lms3dVector normal = GetNormal(corners);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
  }
  const int first = normal[axis] > 0.0 ? (axis + 1) % 3 : (axis + 2) % 3;
  const int second = normal[axis] > 0.0 ? (axis + 2) % 3 : (axis + 1) % 3;
  this->Points.clear();
  for (const lms3dVector& corner : corners)
  {
    this->Points.push_back(
      { corner[first] - corners[0][first], corner[second] - corners[0][second] });
  }
  this->Rounding = GetRounding(corners, first, second);
  return normal[axis] != 0.0;
}

// A convex polygon turns left at each corner, and its x coordinates rise and fall once.
bool lms3dFlatPolygon::IsConvex() const
{
  const std::int32_t count = static_cast<std::int32_t>(this->Points.size());
  int changes = 0;
  double lastStep = 0.0;
  double firstStep = 0.0;
  for (std::int32_t a = 0; a < count; ++a)
  {
    const std::int32_t b = this->GetNext(a);
    const std::int32_t c = this->GetNext(b);
    if (this->GetTurn(a, b, c) < -this->GetMinimumTurn(a, b, c))
    {
      return false;
    }
    const double step = this->Points[b][0] - this->Points[a][0];
    if (step != 0.0)
    {
      changes += step * lastStep < 0.0 ? 1 : 0;
      lastStep = step > 0.0 ? 1.0 : -1.0;
      firstStep = firstStep == 0.0 ? lastStep : firstStep;
    }
  }
  return changes + (firstStep * lastStep < 0.0 ? 1 : 0) <= 2;
}
