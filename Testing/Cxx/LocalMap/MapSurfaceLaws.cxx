// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include "LocalMap/MapNeighbours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace
{
using Beam = ScanGrid::Beam;
using Place = ScanGrid::Place;

// Between beams, at three places for each beam, a bounded map may be off at this share of all places, plus
// this number of places in coarse scans.
constexpr double ShareBetweenBeams = 1e-3;
constexpr double AllowedBetweenBeams = 4.0;

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

// Judges what a beam that returned hits.
void JudgeHits(const MapCase& map, const MapNeighbours& neighbours, const Beam& beam,
  const std::vector<TriangleTree::Hit>& hits, MapVerdict& verdict)
{
  const vtkIdType number = map.Grid.GetReturn(beam);
  const Vector& point = map.Grid.GetPoints()[number];
  if (hits.empty())
  {
    if (!map.IsPlain() || neighbours.IsInTriangle(point))
    {
      verdict.Add("beam", map.Grid.Describe(beam) + " meets no surface");
    }
    return;
  }
  for (const TriangleTree::Hit& hit : hits)
  {
    const Vector at = hit.Range / GetLength(point) * point;
    if (!neighbours.ExplainOnBeam(at, beam))
    {
      verdict.Add("free space",
        map.Grid.Describe(beam) + " meets surface at " + std::to_string(hit.Range) + " m, " +
          ToWords(at),
        GetLength(at - point));
    }
  }
}

// Whether all rays close around a beam hit surface. Surface that ends at the beam, or has a corner there,
// does not count.
bool IsCovered(const MapCase& map, const TriangleTree& surface, const Beam& beam)
{
  constexpr double Offset = 1e-3;
  std::vector<TriangleTree::Hit> hits;
  for (const Place& aside : { Place{ -Offset, -Offset }, Place{ -Offset, Offset },
         Place{ Offset, -Offset }, Place{ Offset, Offset } })
  {
    surface.Cast(map.Grid.GetDirection({ beam.Turn + aside.Turn, beam.Number + aside.Number }),
      -BeamMargin, hits);
    if (hits.empty())
    {
      return false;
    }
  }
  return true;
}

bool IsInGrid(const ScanGrid& grid, const Place& place)
{
  return place.Number <= grid.GetNumberOfBeams() - 1 &&
    (grid.IsClosed() || place.Turn <= grid.GetNumberOfTurns() - 1);
}

// The middles of a cell and of its two sides at the lower beam and the earlier turn.
void JudgeCell(const MapCase& map, const TriangleTree& surface, const MapNeighbours& neighbours,
  const Beam& beam, MapVerdict& verdict)
{
  std::vector<TriangleTree::Hit> hits;
  for (const Place& step : { Place{ 0.5, 0.5 }, Place{ 0.5, 0.0 }, Place{ 0.0, 0.5 } })
  {
    const Place place = { beam.Turn + step.Turn, beam.Number + step.Number };
    if (!IsInGrid(map.Grid, place))
    {
      continue;
    }
    const Vector direction = map.Grid.GetDirection(place);
    surface.Cast(direction, BeamMargin, hits);
    if (hits.empty() && neighbours.AreJoined(place))
    {
      verdict.Add("crack", "beside " + map.Grid.Describe(beam) + " towards " + ToWords(direction));
    }
    for (const TriangleTree::Hit& hit : hits)
    {
      const Vector at = hit.Range * direction;
      if (!neighbours.ExplainBetween(at, place, surface.GetCorners(hit.Triangle)))
      {
        verdict.Add("between beams",
          "beside " + map.Grid.Describe(beam) + " there is surface at " + ToWords(at) + ", " +
            std::to_string(hit.Range) + " m");
      }
    }
  }
}

bool IsBesideAReturn(const MapCase& map, const Vector& point)
{
  const std::vector<Beam> around = map.Grid.GetBeamsAround(map.Grid.GetPlace(point), 1.0);
  if (std::any_of(around.begin(), around.end(),
        [&](const Beam& beam) { return map.Grid.GetReturn(beam) != ScanGrid::NoReturn; }))
  {
    return true;
  }
  // Near a pole turns are close together.
  const std::vector<Vector>& returns = map.Grid.GetPoints();
  for (std::size_t i = 0; i < returns.size(); ++i)
  {
    const double angle = std::atan2(GetLength(Cross(returns[i], point)), Dot(returns[i], point));
    if (angle <= map.Grid.GetCellSize(map.Grid.GetBeam(static_cast<vtkIdType>(i))))
    {
      return true;
    }
  }
  return false;
}

void JudgeOverhang(const MapCase& map, MapVerdict& verdict)
{
  for (const Vector& point : map.Points)
  {
    if (!IsBesideAReturn(map, point))
    {
      verdict.Add("overhang", "the vertex " + ToWords(point));
    }
  }
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

void JudgeBeams(const MapCase& map, const MapNeighbours& neighbours, const TriangleTree& surface,
  MapVerdict& verdict)
{
  std::vector<TriangleTree::Hit> hits;
  for (int turn = 0; turn < map.Grid.GetNumberOfTurns(); ++turn)
  {
    for (int number = 0; number < map.Grid.GetNumberOfBeams(); ++number)
    {
      const Beam beam = { turn, number };
      const vtkIdType at = map.Grid.GetReturn(beam);
      if (at == ScanGrid::NoReturn)
      {
        if (IsCovered(map, surface, beam))
        {
          verdict.Add("miss", map.Grid.Describe(beam) + ", meets surface");
        }
      }
      else if (!map.Grid.IsPole(number) || turn == 0)
      {
        surface.Cast(Normalize(map.Grid.GetPoints()[at]), BeamMargin, hits);
        JudgeHits(map, neighbours, beam, hits, verdict);
      }
      JudgeCell(map, surface, neighbours, beam, verdict);
    }
  }
  if (!map.IsPlain())
  {
    const double places = 3.0 * map.Grid.GetNumberOfTurns() * map.Grid.GetNumberOfBeams();
    verdict.Allow("between beams", AllowedBetweenBeams + ShareBetweenBeams * places);
  }
  JudgeOverhang(map, verdict);
}
