// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace
{
using Edge = std::pair<vtkIdType, vtkIdType>;

std::string DescribeEdge(const MapCase& map, const Edge& edge)
{
  return "from " + ToWords(map.Points[edge.first]) + " to " + ToWords(map.Points[edge.second]);
}

std::array<Edge, 3> GetEdges(const TriangleTree::Triangle& triangle)
{
  const auto [a, b, c] = triangle;
  return { Edge(a, b), Edge(b, c), Edge(c, a) };
}

// Whether a beam lies outside of the grid. Beyond a pole, other turns continue.
bool IsBorder(const ScanGrid& grid, const ScanGrid::Beam& beam)
{
  const int last = grid.GetNumberOfBeams() - 1;
  const bool isBeyondPole =
    last > 0 && ((beam.Number < 0 && grid.IsPole(0)) || (beam.Number > last && grid.IsPole(last)));
  return !grid.Contains(beam) && !isBeyondPole;
}

// Whether the surface may end at a place, judged by the beams up to two cells away.
bool MayEnd(const MapCase& map, const ScanGrid::Place& place)
{
  for (const ScanGrid::Beam& beam : map.Grid.GetBeamsAround(place, 2.0))
  {
    if (!map.Grid.Contains(beam))
    {
      if (IsBorder(map.Grid, beam))
      {
        return true;
      }
      continue;
    }
    const ScanGrid::Beam inFan = { beam.Turn, beam.Number + 1 };
    const ScanGrid::Beam inTurn = { beam.Turn + 1, beam.Number };
    if (map.Grid.GetReturn(beam) == ScanGrid::NoReturn || map.IsSpeckle(beam) ||
      (map.Grid.Contains(inFan) && !map.Steps.AreJoined(beam, inFan)) ||
      (map.Grid.Contains(inTurn) && !map.Steps.AreJoined(beam, inTurn)))
    {
      return true;
    }
  }
  return false;
}

// Samples an edge at each quarter of a cell.
void JudgeBoundary(const MapCase& map, const Edge& edge, MapVerdict& verdict)
{
  constexpr double SamplesInACell = 4.0;
  constexpr double MaximumSamples = 2000.0;
  const Vector& a = map.Points[edge.first];
  const Vector& b = map.Points[edge.second];
  const double angle = std::atan2(GetLength(Cross(a, b)), Dot(a, b));
  const double step = std::min(std::abs(map.Grid.GetFanStep()), std::abs(map.Grid.GetTurnStep()));
  const int samples =
    static_cast<int>(std::clamp(std::ceil(SamplesInACell * angle / step), 1.0, MaximumSamples));
  for (int i = 0; i < samples; ++i)
  {
    const double share = (i + 0.5) / samples;
    const Vector at = (1.0 - share) * a + share * b;
    if (!MayEnd(map, map.Grid.GetPlace(at)))
    {
      verdict.Add("boundary",
        DescribeEdge(map, edge) + ", at " + ToWords(at) + " where the surface goes on",
        GetLength(b - a));
      return;
    }
  }
}

void JudgeTJunctions(const MapCase& map, const std::vector<Edge>& boundary, MapVerdict& verdict)
{
  std::vector<vtkIdType> corners;
  corners.reserve(boundary.size());
  for (const Edge& edge : boundary)
  {
    corners.push_back(edge.first);
  }
  const auto isLower = [&](vtkIdType i, double x) { return map.Points[i][0] < x; };
  std::sort(corners.begin(), corners.end(),
    [&](vtkIdType i, vtkIdType j) { return map.Points[i][0] < map.Points[j][0]; });
  for (const Edge& edge : boundary)
  {
    const Vector& a = map.Points[edge.first];
    const Vector& b = map.Points[edge.second];
    const double margin = MapCase::GetRounding(std::max(GetLength(a), GetLength(b)));
    auto corner =
      std::lower_bound(corners.begin(), corners.end(), std::min(a[0], b[0]) - margin, isLower);
    for (; corner != corners.end() && map.Points[*corner][0] <= std::max(a[0], b[0]) + margin;
         ++corner)
    {
      const Vector& point = map.Points[*corner];
      if (GetLength(point - a) > margin && GetLength(point - b) > margin &&
        GetDistance(point, a, b) <= margin)
      {
        verdict.Add("T-junction", ToWords(point) + " in the edge " + DescribeEdge(map, edge));
      }
    }
  }
}
} // namespace

void JudgeEdges(const MapCase& map, MapVerdict& verdict)
{
  std::map<Edge, int> uses;
  for (const TriangleTree::Triangle& triangle : map.Triangles)
  {
    for (const Edge& edge : GetEdges(triangle))
    {
      if (++uses[edge] == 2)
      {
        verdict.Add("edge", DescribeEdge(map, edge) + " has two triangles on one side");
      }
    }
  }
  const auto isShared = [&](const Edge& edge) {
    return uses.count({ edge.second, edge.first }) > 0;
  };
  std::vector<Edge> boundary;
  vtkIdType undirected = 0;
  for (const auto& [edge, count] : uses)
  {
    undirected += !isShared(edge) || edge.first < edge.second;
    if (!isShared(edge))
    {
      boundary.push_back(edge);
    }
  }
  verdict.NumberOfBoundaryEdges = static_cast<vtkIdType>(boundary.size());
  verdict.EulerCharacteristic += static_cast<vtkIdType>(map.Triangles.size()) - undirected;
  for (const TriangleTree::Triangle& triangle : map.Triangles)
  {
    const std::array<Edge, 3> edges = GetEdges(triangle);
    const bool isAlone = std::none_of(edges.begin(), edges.end(), isShared);
    for (const Edge& edge : edges)
    {
      if (!isShared(edge) && !(isAlone && IsFacetOfPole(map, triangle)))
      {
        JudgeBoundary(map, edge, verdict);
      }
    }
  }
  JudgeTJunctions(map, boundary, verdict);
}
