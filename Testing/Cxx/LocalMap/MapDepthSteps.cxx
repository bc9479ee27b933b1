// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include "LocalMap/MapNeighbours.h"

#include <algorithm>
#include <cmath>

namespace
{
using Beam = ScanGrid::Beam;

// Walks from one side to the other, in strides that a bridge would climb without a jump.
bool IsContinuous(const MapCase& map, const TriangleTree& surface, const Beam& a, const Beam& b)
{
  const double tolerance = map.Steps.GetTolerance(a, b);
  const double size =
    std::abs(map.Grid.GetRange(map.Grid.GetReturn(a)) - map.Grid.GetRange(map.Grid.GetReturn(b)));
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
} // namespace

void JudgeDepthSteps(const MapCase& map, const MapNeighbours& neighbours,
  const TriangleTree& surface, MapVerdict& verdict)
{
  const TriangleTree* scene = neighbours.GetScene();
  for (int turn = 0; turn < map.Grid.GetNumberOfTurns(); ++turn)
  {
    for (int number = 0; number < map.Grid.GetNumberOfBeams(); ++number)
    {
      const Beam beam = { turn, number };
      for (const Beam& next : { Beam{ turn, number + 1 }, Beam{ turn + 1, number } })
      {
        if (map.Steps.AreApart(beam, next) && IsContinuous(map, surface, beam, next) &&
          !(scene && IsContinuous(map, *scene, beam, next)))
        {
          verdict.Add(
            "bridge", "from " + map.Grid.Describe(beam) + " to " + map.Grid.Describe(next));
        }
      }
    }
  }
}
