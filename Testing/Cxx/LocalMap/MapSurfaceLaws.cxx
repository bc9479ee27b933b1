// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include "LocalMap/MapNeighbours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;
using Place = ScanGrid::Place;

// Between beams, at three places for each beam, a bounded map may be off at this share of all
// places, plus this number of places in coarse scans.
constexpr double ShareBetweenBeams = 1e-3;
constexpr double AllowedBetweenBeams = 4.0;

// Whether a return is that of a speckle that is left out. Where the map is the plain grid, there is
// no surface behind it.
bool IsLeftOut(const MapCase& map, const Beam& beam)
{
  return !map.Promise.KeepSpeckles && map.IsSpeckle(beam);
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

void JudgeOverhang(const MapCase& map, const MapNeighbours& neighbours, MapVerdict& verdict)
{
  const MapNeighbours* ideal = neighbours.GetIdeal();
  for (const Vector& point : map.Points)
  {
    if (!IsBesideAReturn(map, point) && !(ideal && IsBesideAReturn(ideal->GetMap(), point)))
    {
      verdict.Add("overhang", "the vertex " + ToWords(point));
    }
  }
}
} // namespace

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
      if (at != ScanGrid::NoReturn && (!map.Grid.IsPole(number) || turn == 0))
      {
        surface.Cast(Normalize(map.Grid.GetPoints()[at]), BeamMargin, hits);
        if (!hits.empty() || !IsLeftOut(map, beam))
        {
          JudgeHits(map, neighbours, beam, hits, verdict);
        }
      }
      JudgeCell(map, surface, neighbours, beam, verdict);
    }
  }
  if (!map.IsPlain())
  {
    const double places = 3.0 * map.Grid.GetNumberOfTurns() * map.Grid.GetNumberOfBeams();
    verdict.Allow("between beams", AllowedBetweenBeams + ShareBetweenBeams * places);
  }
  JudgeOverhang(map, neighbours, verdict);
}
