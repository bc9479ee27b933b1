// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
// The ranges of all returns at a pole that are farther than the bound from their median, if all
// returns span more than twice the bound.
std::vector<double> GetOthers(const MapCase& map, const ScanGrid::Beam& pole)
{
  std::vector<double> ranges;
  for (vtkIdType number : map.Grid.GetReturns(pole))
  {
    ranges.push_back(map.Grid.GetRange(number));
  }
  const double bound = map.Promise.MaximumError;
  if (ranges.empty() ||
    *std::max_element(ranges.begin(), ranges.end()) -
        *std::min_element(ranges.begin(), ranges.end()) <=
      2.0 * bound)
  {
    return {};
  }
  const double median = map.Grid.GetRange(map.Grid.GetReturn(pole));
  ranges.erase(std::remove_if(ranges.begin(), ranges.end(),
                 [&](double range) { return std::abs(range - median) <= bound; }),
    ranges.end());
  return ranges;
}

// Whether the beam of a pole hits a triangle that is smaller than a cell, within the bound of one
// of these returns.
bool IsFacetAt(const MapCase& map, const std::array<Vector, 3>& corners, const ScanGrid::Beam& pole)
{
  const Vector direction = map.Grid.GetDirection({ 1.0 * pole.Turn, 1.0 * pole.Number });
  const double cosine = std::cos(map.Grid.GetCellSize(pole));
  const bool isSmall = std::all_of(corners.begin(), corners.end(),
    [&](const Vector& corner) { return Dot(Normalize(corner), direction) > cosine; });
  std::vector<TriangleTree::Hit> hits;
  TriangleTree({ corners.begin(), corners.end() }, { { 0, 1, 2 } })
    .Cast(direction, BeamMargin, hits);
  const std::vector<double> others = GetOthers(map, pole);
  return isSmall && !hits.empty() &&
    std::any_of(others.begin(), others.end(),
      [&](double range)
      {
        return std::abs(range - hits.front().Range) <=
          map.Promise.MaximumError + MapCase::GetRounding(range);
      });
}
} // namespace

bool IsFacetOfPole(const MapCase& map, const TriangleTree::Triangle& triangle)
{
  const std::array<Vector, 3> corners = { map.Points[triangle[0]], map.Points[triangle[1]],
    map.Points[triangle[2]] };
  const auto isFacetAt = [&](int number) {
    return map.Grid.IsPole(number) && IsFacetAt(map, corners, { 0, number });
  };
  return !map.IsPlain() && (isFacetAt(0) || isFacetAt(map.Grid.GetNumberOfBeams() - 1));
}
