// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace
{
// The smallest height of a triangle, as a share of its longest edge, at which it has an area.
constexpr double MinimumHeight = 1e-9;

// The tolerance for unit vectors in single precision.
constexpr double NormalRounding = 1e-6;

using Edge = std::pair<vtkIdType, vtkIdType>;

std::string DescribeEdge(const MapCase& map, const Edge& edge)
{
  return "from " + ToWords(map.Points[edge.first]) + " to " + ToWords(map.Points[edge.second]);
}

void JudgeTriangle(const MapCase& map, std::size_t number, MapVerdict& verdict)
{
  const auto [i, j, k] = map.Triangles[number];
  const Vector& a = map.Points[i];
  const Vector& b = map.Points[j];
  const Vector& c = map.Points[k];
  const Vector normal = Cross(b - a, c - a);
  const double longest = std::max({ GetLength(b - a), GetLength(c - b), GetLength(a - c) });
  const bool hasArea = GetLength(normal) > MinimumHeight * longest * longest;
  if (!hasArea || !(Dot(normal, a) < 0.0))
  {
    verdict.Add(hasArea ? "facing" : "area",
      "triangle " + std::to_string(number) + " of " + ToWords(a) + ", " + ToWords(b) + ", " +
        ToWords(c));
  }
  if (vtkDataArray* normals = map.Map->GetCellData()->GetNormals())
  {
    Vector given;
    normals->GetTuple(static_cast<vtkIdType>(number), given.data());
    if (!(GetLength(given - Normalize(normal)) <= NormalRounding))
    {
      verdict.Add("normal", "triangle " + std::to_string(number) + " has " + ToWords(given));
    }
  }
}

void JudgePoint(const MapCase& map, vtkIdType number, MapVerdict& verdict)
{
  const Vector& point = map.Points[number];
  const auto describe = [&] { return "point " + std::to_string(number) + " at " + ToWords(point); };
  const double range = GetLength(point);
  if (!std::isfinite(range) || range == 0.0)
  {
    verdict.Add("point", describe());
    return;
  }
  const double given = map.Map->GetPointData()->GetArray("Range")->GetTuple1(number);
  if (!(std::abs(given - range) <= MapCase::GetRounding(range)))
  {
    verdict.Add("range", describe() + " has the Range " + std::to_string(given));
  }
  if (vtkDataArray* normals = map.Map->GetPointData()->GetNormals())
  {
    Vector normal;
    normals->GetTuple(number, normal.data());
    if (!(std::abs(GetLength(normal) - 1.0) <= NormalRounding) ||
      !(Dot(normal, point) <= NormalRounding * range))
    {
      verdict.Add("normal", describe() + " has the normal " + ToWords(normal));
    }
  }
}

void JudgeUse(const MapCase& map, MapVerdict& verdict)
{
  std::vector<bool> isUsed(map.Points.size(), false);
  for (const TriangleTree::Triangle& triangle : map.Triangles)
  {
    for (vtkIdType corner : triangle)
    {
      isUsed[corner] = true;
    }
  }
  for (std::size_t i = 0; i < isUsed.size() && !map.IsPlain(); ++i)
  {
    if (!isUsed[i])
    {
      verdict.Add("point", "point " + std::to_string(i) + " belongs to no triangle");
    }
  }
  verdict.EulerCharacteristic = std::count(isUsed.begin(), isUsed.end(), true);
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
    if (map.Grid.GetReturn(beam) == ScanGrid::NoReturn ||
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

void JudgeShape(const MapCase& map, MapVerdict& verdict)
{
  vtkDataArray* ranges = map.Map->GetPointData()->GetArray("Range");
  if (!ranges || ranges->GetDataType() != VTK_DOUBLE)
  {
    verdict.Add("range", "there is no Range of float64");
    return;
  }
  if (!map.Map->GetPointData()->GetNormals() && !map.Map->GetCellData()->GetNormals())
  {
    verdict.Add("normal", "there are no Normals");
  }
  for (std::size_t i = 0; i < map.Points.size(); ++i)
  {
    JudgePoint(map, static_cast<vtkIdType>(i), verdict);
  }
  for (std::size_t i = 0; i < map.Triangles.size(); ++i)
  {
    JudgeTriangle(map, i, verdict);
  }
  JudgeUse(map, verdict);
}

void JudgeEdges(const MapCase& map, MapVerdict& verdict)
{
  std::map<Edge, int> uses;
  for (const auto& [a, b, c] : map.Triangles)
  {
    for (const Edge& edge : { Edge(a, b), Edge(b, c), Edge(c, a) })
    {
      if (++uses[edge] == 2)
      {
        verdict.Add("edge", DescribeEdge(map, edge) + " has two triangles on one side");
      }
    }
  }
  std::vector<Edge> boundary;
  vtkIdType undirected = 0;
  for (const auto& [edge, count] : uses)
  {
    const bool isShared = uses.count({ edge.second, edge.first }) > 0;
    undirected += !isShared || edge.first < edge.second;
    if (!isShared)
    {
      boundary.push_back(edge);
    }
  }
  verdict.NumberOfBoundaryEdges = static_cast<vtkIdType>(boundary.size());
  verdict.EulerCharacteristic += static_cast<vtkIdType>(map.Triangles.size()) - undirected;
  for (const Edge& edge : boundary)
  {
    JudgeBoundary(map, edge, verdict);
  }
  JudgeTJunctions(map, boundary, verdict);
}
