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

// Whether one vertex can be within the bound of all returns of a pole.
bool CanBeOneVertex(const MapCase& map, const Beam& pole)
{
  std::vector<double> ranges;
  for (vtkIdType number : map.Grid.GetReturns(pole))
  {
    ranges.push_back(map.Grid.GetRange(number));
  }
  const auto [nearest, farthest] = std::minmax_element(ranges.begin(), ranges.end());
  return *farthest - *nearest <= 2.0 * map.Promise.MaximumError;
}

// How far from the surface a return may be. If the vertex of a pole cannot be within the bound of all
// returns, the return of median range counts.
double GetBound(const MapCase& map, vtkIdType number)
{
  const ScanGrid& grid = map.Grid;
  const Beam beam = grid.GetBeam(number);
  const double range = grid.GetRange(number);
  const double offMedian = std::abs(range - grid.GetRange(grid.GetReturn(beam)));
  return map.Promise.MaximumError + MapCase::GetRounding(range) +
    (CanBeOneVertex(map, beam) ? 0.0 : offMedian);
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

// The distances from the vertices of a plain grid. The vertex of a pole is its return of median range.
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
  for (std::size_t i = 0; i < deviations.size(); ++i)
  {
    verdict.LargestDeviation = std::max(verdict.LargestDeviation, deviations[i]);
    const auto number = static_cast<vtkIdType>(i);
    if (!(deviations[i] <= GetBound(map, number)))
    {
      verdict.Add("bound",
        map.Grid.Describe(map.Grid.GetBeam(number)) + " is " + std::to_string(deviations[i]) +
          " m from the surface",
        deviations[i]);
    }
  }
}
