// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A polygon in space, projected to the plane.
 */
#ifndef lms3dFlatPolygon_h
#define lms3dFlatPolygon_h

#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// The polygon is seen along the coordinate axis that is nearest to Newell's normal, from the side
/// where it turns counter-clockwise.
class lms3dFlatPolygon
{
public:
  using Point = std::array<double, 2>;

  /// Replaces the polygon. Requires three corners or more, with finite coordinates whose products
  /// are finite. Returns false if all corners are on a line.
  bool Project(const std::vector<lms3dVector>& corners);

  const std::vector<Point>& GetPoints() const { return this->Points; }

  /// Returns twice the signed area of a triangle of corners, positive if it turns
  /// counter-clockwise.
  double GetTurn(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    const Point& p = this->Points[a];
    const Point& q = this->Points[b];
    const Point& r = this->Points[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  /// Returns the turn up to which three corners count as collinear, because of rounding. It is
  /// proportional to the size of their triangle.
  double GetMinimumTurn(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    const Point& p = this->Points[a];
    const Point& q = this->Points[b];
    const Point& r = this->Points[c];
    const auto [left, right] = std::minmax({ p[0], q[0], r[0] });
    const auto [bottom, top] = std::minmax({ p[1], q[1], r[1] });
    return this->Rounding * std::max(right - left, top - bottom);
  }

  /// Returns the neighbours of a corner on the outline.
  std::int32_t GetNext(std::int32_t corner) const
  {
    return corner + 1 < static_cast<std::int32_t>(this->Points.size()) ? corner + 1 : 0;
  }
  std::int32_t GetPrevious(std::int32_t corner) const
  {
    return (corner > 0 ? corner : static_cast<std::int32_t>(this->Points.size())) - 1;
  }

  /// Returns whether the outline turns left or is straight at each corner, and goes around once.
  bool IsConvex() const;

private:
  std::vector<Point> Points;
  /// The deviation from a straight line up to which corners count as collinear.
  double Rounding = 0.0;
};

#endif
