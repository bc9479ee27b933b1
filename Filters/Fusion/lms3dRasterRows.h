// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a raster in a convex polygon, row by row.
 */
#ifndef lms3dRasterRows_h
#define lms3dRasterRows_h

#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

/// Where a convex polygon meets the rows between two heights.
template <typename Points>
struct lms3dStripSpan
{
  lms3dStripSpan(const Points& points, double bottom, double top)
  {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AddEdge(points[i], points[(i + 1) % count], bottom, top);
    }
  }

  bool IsEmpty() const { return this->First > this->Last; }

  double First = std::numeric_limits<double>::infinity();
  double Last = -std::numeric_limits<double>::infinity();

private:
  void Add(double u)
  {
    this->First = std::min(this->First, u);
    this->Last = std::max(this->Last, u);
  }

  void AddEdge(const lms3dPoint2& a, const lms3dPoint2& b, double bottom, double top)
  {
    if (a[1] >= bottom && a[1] <= top)
    {
      this->Add(a[0]);
    }
    for (const double height : { bottom, top })
    {
      if ((a[1] < height && b[1] > height) || (a[1] > height && b[1] < height))
      {
        this->Add(a[0] + (b[0] - a[0]) * ((height - a[1]) / (b[1] - a[1])));
      }
    }
  }
};

/// Calls `visit` with a row, its first and its last cell, for all cells that a convex polygon touches. Stops, and
/// returns false, if `visit` returns false.
template <typename Points, typename Visitor>
bool lms3dForTouchedRows(const Points& points, const Visitor& visit)
{
  double low = points[0][1];
  double high = low;
  for (const lms3dPoint2& point : points)
  {
    low = std::min(low, point[1]);
    high = std::max(high, point[1]);
  }
  const auto lastRow = static_cast<std::int32_t>(std::floor(high));
  for (auto row = static_cast<std::int32_t>(std::floor(low)); row <= lastRow; ++row)
  {
    const lms3dStripSpan<Points> span(points, row, row + 1.0);
    if (!span.IsEmpty() &&
      !visit(row, static_cast<std::int32_t>(std::floor(span.First)),
        static_cast<std::int32_t>(std::floor(span.Last))))
    {
      return false;
    }
  }
  return true;
}

/// The same for the cells whose centre lies in the polygon.
template <typename Points, typename Visitor>
bool lms3dForCentreRows(const Points& points, const Visitor& visit)
{
  double low = points[0][1];
  double high = low;
  for (const lms3dPoint2& point : points)
  {
    low = std::min(low, point[1]);
    high = std::max(high, point[1]);
  }
  const auto lastRow = static_cast<std::int32_t>(std::floor(high - 0.5));
  for (auto row = static_cast<std::int32_t>(std::ceil(low - 0.5)); row <= lastRow; ++row)
  {
    const lms3dStripSpan<Points> span(points, row + 0.5, row + 0.5);
    const auto first = static_cast<std::int32_t>(std::ceil(span.First - 0.5));
    const auto last = static_cast<std::int32_t>(std::floor(span.Last - 0.5));
    if (!span.IsEmpty() && first <= last && !visit(row, first, last))
    {
      return false;
    }
  }
  return true;
}

#endif
