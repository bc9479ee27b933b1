// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a raster in a convex polygon, strip by strip.
 */
#ifndef lms3dRasterRows_h
#define lms3dRasterRows_h

#include "Fusion/Cells/lms3dCellStrip.h"
#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

/// Where a convex polygon meets horizontal lines, and the strips between them.
class lms3dLineSpans
{
public:
  /// The first line has the height `first`; the others follow at a distance of 1.
  lms3dLineSpans(double first, int count)
    : FirstLine(first)
    , Count(count)
  {
    std::fill_n(this->First.begin(), count, std::numeric_limits<double>::infinity());
    std::fill_n(this->Last.begin(), count, -std::numeric_limits<double>::infinity());
  }

  double GetFirst(int line) const { return this->First[line]; }
  double GetLast(int line) const { return this->Last[line]; }

  void Add(int line, double u)
  {
    if (line >= 0 && line < this->Count)
    {
      this->First[line] = std::min(this->First[line], u);
      this->Last[line] = std::max(this->Last[line], u);
    }
  }

  /// Adds the crossings of an edge with lines strictly between its ends.
  void AddEdge(const lms3dPoint2& a, const lms3dPoint2& b)
  {
    const auto [low, high] = std::minmax(a[1], b[1]);
    const double end = this->Count;
    const auto first = static_cast<int>(std::clamp(low - this->FirstLine, 0.0, end));
    const auto last = lms3dGetCellFrom(std::clamp(high - this->FirstLine, -1.0, end - 1.0));
    for (int line = first; line <= last; ++line)
    {
      const double height = this->FirstLine + line;
      if (low < height && height < high)
      {
        this->Add(line, a[0] + (b[0] - a[0]) * ((height - a[1]) / (b[1] - a[1])));
      }
    }
  }

private:
  const double FirstLine;
  const int Count;
  std::array<double, lms3dCellStrip::Size + 1> First;
  std::array<double, lms3dCellStrip::Size + 1> Last;
};

/// All cells that a polygon touches lie in the box.
template <typename Points>
lms3dCellBox lms3dGetTouchedBox(const Points& points)
{
  lms3dPoint2 low = points[0];
  lms3dPoint2 high = points[0];
  for (const lms3dPoint2& point : points)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  return { lms3dGetCellOf(low[0]), lms3dGetCellOf(high[0]), lms3dGetCellOf(low[1]),
    lms3dGetCellOf(high[1]) };
}

/// The lowest and the highest coordinate along the second axis.
template <typename Points>
std::pair<double, double> lms3dGetHeights(const Points& points)
{
  std::pair<double, double> heights = { points[0][1], points[0][1] };
  for (const lms3dPoint2& point : points)
  {
    heights.first = std::min(heights.first, point[1]);
    heights.second = std::max(heights.second, point[1]);
  }
  return heights;
}

/// The cells that a convex polygon touches in rows from `row` to `last`, which lie in one row of
/// blocks.
template <typename Points>
lms3dCellStrip lms3dGetTouchedStrip(const Points& points, std::int32_t row, std::int32_t last)
{
  const int count = last - row + 1;
  lms3dLineSpans lines(row, count + 1);
  lms3dLineSpans corners(row, count);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lines.AddEdge(points[i], points[(i + 1) % points.size()]);
    const double floor = lms3dGetCellOf(points[i][1]);
    const double place = floor - row;
    if (place >= 0.0 && place <= count)
    {
      corners.Add(static_cast<int>(place), points[i][0]);
      corners.Add(static_cast<int>(place) - (points[i][1] == floor ? 1 : 0), points[i][0]);
    }
  }
  lms3dCellStrip strip;
  strip.Row = row;
  for (int i = 0; i < count; ++i)
  {
    const double from = std::min({ corners.GetFirst(i), lines.GetFirst(i), lines.GetFirst(i + 1) });
    const double to = std::max({ corners.GetLast(i), lines.GetLast(i), lines.GetLast(i + 1) });
    if (from > to)
    {
      strip.AddEmpty();
      continue;
    }
    strip.Add(lms3dGetCellOf(from), lms3dGetCellOf(to));
  }
  return strip;
}

/// The same for the cells whose centre lies in the polygon.
template <typename Points>
lms3dCellStrip lms3dGetCentreStrip(const Points& points, std::int32_t row, std::int32_t last)
{
  const int count = last - row + 1;
  lms3dLineSpans lines(row + 0.5, count);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lines.AddEdge(points[i], points[(i + 1) % points.size()]);
    const double place = points[i][1] - (row + 0.5);
    if (place == std::floor(place) && place >= 0.0 && place < count)
    {
      lines.Add(static_cast<int>(place), points[i][0]);
    }
  }
  lms3dCellStrip strip;
  strip.Row = row;
  for (int i = 0; i < count; ++i)
  {
    if (lines.GetFirst(i) > lines.GetLast(i))
    {
      strip.AddEmpty();
      continue;
    }
    strip.Add(lms3dGetCellFrom(lines.GetFirst(i) - 0.5), lms3dGetCellOf(lines.GetLast(i) - 0.5));
  }
  return strip;
}

/// Calls `visit` with the first and the last of the rows from `first` to `last` in each row of
/// blocks. Stops, and returns false, if `visit` returns false.
template <typename Visitor>
bool lms3dForRowsOfBlocks(std::int32_t first, std::int32_t last, const Visitor& visit)
{
  constexpr std::int32_t InBlock = lms3dCellStrip::Size - 1;
  for (std::int32_t row = first; row <= last; row = (row | InBlock) + 1)
  {
    if (!visit(row, std::min(row | InBlock, last)))
    {
      return false;
    }
  }
  return true;
}

/// Calls `visit` with the strips of all cells that a convex polygon touches. Stops, and returns
/// false, if `visit` returns false.
template <typename Points, typename Visitor>
bool lms3dForTouchedStrips(const Points& points, const Visitor& visit)
{
  const auto [low, high] = lms3dGetHeights(points);
  return lms3dForRowsOfBlocks(lms3dGetCellOf(low), lms3dGetCellOf(high),
    [&](std::int32_t first, std::int32_t last)
    { return visit(lms3dGetTouchedStrip(points, first, last)); });
}

/// The same for the cells whose centre lies in the polygon.
template <typename Points, typename Visitor>
bool lms3dForCentreStrips(const Points& points, const Visitor& visit)
{
  const auto [low, high] = lms3dGetHeights(points);
  return lms3dForRowsOfBlocks(lms3dGetCellFrom(low - 0.5), lms3dGetCellOf(high - 0.5),
    [&](std::int32_t first, std::int32_t last)
    { return visit(lms3dGetCentreStrip(points, first, last)); });
}

/// Calls `visit` with each row of a strip that has cells, its first and its last cell. Stops, and
/// returns false, if `visit` returns false.
template <typename Visitor>
bool lms3dForRows(const lms3dCellStrip& strip, const Visitor& visit)
{
  for (int i = 0; i < strip.Count; ++i)
  {
    if (strip.First[i] <= strip.Last[i] && !visit(strip.Row + i, strip.First[i], strip.Last[i]))
    {
      return false;
    }
  }
  return true;
}

/// The same for all cells that a convex polygon touches.
template <typename Points, typename Visitor>
bool lms3dForTouchedRows(const Points& points, const Visitor& visit)
{
  return lms3dForTouchedStrips(
    points, [&](const lms3dCellStrip& strip) { return lms3dForRows(strip, visit); });
}

#endif
