// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include "LocalMap/MapNeighbours.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

// Walks from one side to the other, in strides that a bridge would climb without a jump.
bool IsContinuous(const MapCase& map, const TriangleTree& surface, const Beam& a, const Beam& b)
{
  const double size =
    std::abs(map.Grid.GetRange(map.Grid.GetReturn(a)) - map.Grid.GetRange(map.Grid.GetReturn(b)));
  const double tolerance = std::min(map.Steps.GetTolerance(a, b), size);
  const int strides = static_cast<int>(std::clamp(std::ceil(8.0 * size / tolerance), 8.0, 400.0));
  std::vector<TriangleTree::Hit> hits;
  double last = 0.0;
  for (int i = 0; i <= strides; ++i)
  {
    const double share = static_cast<double>(i) / strides;
    surface.Cast(map.Grid.GetDirection({ a.Turn + share * (b.Turn - a.Turn),
                   a.Number + share * (b.Number - a.Number) }),
      BeamMargin, hits);
    if (hits.empty())
    {
      return false;
    }
    const double nearest = std::min_element(hits.begin(), hits.end(),
      [](const auto& p, const auto& q) {
        return p.Range < q.Range;
      })->Range;
    if (i > 0 && std::abs(nearest - last) > 0.5 * tolerance)
    {
      return false;
    }
    last = nearest;
  }
  return true;
}

using IsJudged = std::function<bool(const Beam& beam, const Beam& next)>;

void JudgePairs(const MapCase& map, const TriangleTree* scene, const TriangleTree& surface,
  const IsJudged& isJudged, MapVerdict& verdict)
{
  for (int turn = 0; turn < map.Grid.GetNumberOfTurns(); ++turn)
  {
    for (int number = 0; number < map.Grid.GetNumberOfBeams(); ++number)
    {
      const Beam beam = { turn, number };
      for (const Beam& next : { Beam{ turn, number + 1 }, Beam{ turn + 1, number } })
      {
        if (map.Steps.AreApart(beam, next) && isJudged(beam, next) &&
          IsContinuous(map, surface, beam, next) &&
          !(scene && IsContinuous(map, *scene, beam, next)))
        {
          verdict.Add(
            "bridge", "from " + map.Grid.Describe(beam) + " to " + map.Grid.Describe(next));
        }
      }
    }
  }
}

// Whether a beam meets the surface first where the beam has its return.
bool MeetsItsReturn(const MapCase& map, const TriangleTree& surface, const Beam& beam)
{
  const vtkIdType number = map.Grid.GetReturn(beam);
  const Vector& point = map.Grid.GetPoints()[number];
  std::vector<TriangleTree::Hit> hits;
  surface.Cast(Normalize(point), BeamMargin, hits);
  const auto nearest = std::min_element(hits.begin(), hits.end(),
    [](const TriangleTree::Hit& p, const TriangleTree::Hit& q) { return p.Range < q.Range; });
  return nearest != hits.end() &&
    GetDistance(point, surface.GetCorners(nearest->Triangle)) <=
    map.Promise.MaximumError + map.Promise.Noise + MapCase::GetRounding(GetLength(point));
}

// Judges steps that the scan itself does not show, because it has lost a return beside them. Errors
// cannot hide such a step if it exceeds them.
void JudgeLostSteps(const MapCase& map, const MapCase& ideal, const TriangleTree* scene,
  const TriangleTree& surface, MapVerdict& verdict)
{
  const double errors = 2.0 * (map.Promise.MaximumError + map.Promise.Noise);
  const auto isLost = [&](const Beam& beam)
  { return map.Grid.GetReturn(beam) == ScanGrid::NoReturn; };
  const auto getRange = [&](const Beam& beam)
  { return ideal.Grid.GetRange(ideal.Grid.GetReturn(beam)); };
  const auto isJudged = [&](const Beam& beam, const Beam& next)
  {
    return (isLost(beam) || isLost(next)) &&
      std::abs(getRange(beam) - getRange(next)) > ideal.Steps.GetTolerance(beam, next) + errors &&
      MeetsItsReturn(ideal, surface, beam) && MeetsItsReturn(ideal, surface, next);
  };
  JudgePairs(ideal, scene, surface, isJudged, verdict);
}
} // namespace

void JudgeDepthSteps(const MapCase& map, const MapNeighbours& neighbours,
  const TriangleTree& surface, MapVerdict& verdict)
{
  const TriangleTree* scene = neighbours.GetScene();
  const MapCase* ideal = neighbours.GetIdeal() ? &neighbours.GetIdeal()->GetMap() : nullptr;
  // Behind a stray return, and behind a speckle that is left out, the surface goes on.
  const auto isJudged = [&](const Beam& beam, const Beam& next)
  {
    if (!map.Promise.KeepSpeckles &&
      (!MeetsItsReturn(map, surface, beam) || !MeetsItsReturn(map, surface, next)))
    {
      return false;
    }
    // Lost returns do not make a step certain that the scan without errors leaves open.
    return !ideal || ideal->Steps.AreApart(beam, next) || !MeetsItsReturn(*ideal, surface, beam) ||
      !MeetsItsReturn(*ideal, surface, next);
  };
  JudgePairs(map, scene, surface, isJudged, verdict);
  if (ideal)
  {
    JudgeLostSteps(map, *ideal, scene, surface, verdict);
  }
}
