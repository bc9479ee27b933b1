// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

// How far from the surface a return may be. In a plain grid, the return of median range counts at a
// pole.
double GetBound(const MapCase& map, vtkIdType number)
{
  const ScanGrid& grid = map.Grid;
  const double range = grid.GetRange(number);
  const double offMedian = std::abs(range - grid.GetRange(grid.GetReturn(grid.GetBeam(number))));
  return map.Promise.MaximumError + MapCase::GetRounding(range) + (map.IsPlain() ? offMedian : 0.0);
}

// Whether speckles are no part of the map.
bool MayLeaveOut(const MapCase& map)
{
  return !map.Promise.KeepSpeckles && map.Promise.MaximumSpeckleSize > 0 && !map.IsPlain();
}

// The distance from the nearest triangle that the return's beam hits.
double GetDeviationOnBeam(const Vector& point, const TriangleTree& surface)
{
  std::vector<TriangleTree::Hit> hits;
  surface.Cast(Normalize(point), BeamMargin, hits);
  double nearest = std::numeric_limits<double>::infinity();
  for (const TriangleTree::Hit& hit : hits)
  {
    nearest = std::min(nearest, GetDistance(point, surface.GetCorners(hit.Triangle)));
  }
  return nearest;
}

// The distances from the vertices of a plain grid. The vertex of a pole is its return of median
// range.
std::vector<double> GetDeviationsFromVertices(const MapCase& map)
{
  const std::set<Vector> vertices(map.Points.begin(), map.Points.end());
  std::vector<double> deviations;
  for (std::size_t i = 0; i < map.Grid.GetPoints().size(); ++i)
  {
    const vtkIdType number = static_cast<vtkIdType>(i);
    const Vector& point = map.Grid.GetPoints()[map.Grid.GetReturn(map.Grid.GetBeam(number))];
    deviations.push_back(vertices.count(point) ? GetLength(map.Grid.GetPoints()[i] - point)
                                               : std::numeric_limits<double>::infinity());
  }
  return deviations;
}

// The distances from the whole surface.
std::vector<double> GetDeviations(
  const MapCase& map, const TriangleTree& surface, MapVerdict& verdict)
{
  std::vector<double> deviations;
  for (const Vector& point : map.Grid.GetPoints())
  {
    const double onBeam = GetDeviationOnBeam(point, surface);
    verdict.LargestDeviationOnBeams = std::max(verdict.LargestDeviationOnBeams, onBeam);
    deviations.push_back(surface.GetDistance(point, onBeam));
  }
  return deviations;
}
} // namespace

void JudgeDistances(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict)
{
  const std::vector<double> deviations =
    map.IsPlain() ? GetDeviationsFromVertices(map) : GetDeviations(map, surface, verdict);
  std::vector<vtkIdType> leftOut;
  for (std::size_t i = 0; i < deviations.size(); ++i)
  {
    const auto number = static_cast<vtkIdType>(i);
    const bool isWithin = deviations[i] <= GetBound(map, number);
    if (!isWithin && MayLeaveOut(map))
    {
      leftOut.push_back(number);
      continue;
    }
    if (!(MayLeaveOut(map) && map.IsSpeckle(map.Grid.GetBeam(number))))
    {
      verdict.LargestDeviation = std::max(verdict.LargestDeviation, deviations[i]);
    }
    if (!isWithin)
    {
      verdict.Add("bound",
        map.Grid.Describe(map.Grid.GetBeam(number)) + " is " + std::to_string(deviations[i]) +
          " m from the surface",
        deviations[i]);
    }
  }
  JudgeSpeckles(map, surface, leftOut, verdict);
}
