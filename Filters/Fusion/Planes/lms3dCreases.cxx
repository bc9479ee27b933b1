// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dCreases.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace
{
// The sine of the smallest angle at a crease.
constexpr double SmallestSine = 0.17;
// Cells: how far the edge of a local map may be from the line in which its planes meet.
constexpr double CreaseReach = 6.0;
// Cells: how much a crease grows before it changes its planes.
constexpr double CreaseGrowth = 16.0;

// Whether the parts have a part, apart from the gap that they may have.
bool Have(const lms3dCreaseParts& parts, double first, double last, double gap)
{
  return std::any_of(parts.begin(), parts.end(),
    [&](const auto& part) { return first >= part.first - gap && last <= part.second + gap; });
}

// Parts become one if the gap between them is not larger.
void Merge(lms3dCreaseParts& parts, double first, double last, double gap)
{
  parts.emplace_back(first, last);
  std::sort(parts.begin(), parts.end());
  lms3dCreaseParts merged;
  for (const auto& part : parts)
  {
    if (!merged.empty() && part.first <= merged.back().second + gap)
    {
      merged.back().second = std::max(merged.back().second, part.second);
    }
    else
    {
      merged.push_back(part);
    }
  }
  parts = merged;
}

/// The line in which two planes meet.
struct Line
{
  lms3dVector Point;
  /// The cross product of the normals, scaled to length 1.
  lms3dVector Direction;
};

bool Intersect(const lms3dPlaneFrame& a, const lms3dPlaneFrame& b, Line& line)
{
  const lms3dVector cross = lms3dCross(a.GetNormal(), b.GetNormal());
  const double square = lms3dDot(cross, cross);
  if (square < SmallestSine * SmallestSine)
  {
    return false;
  }
  const double offsetA = -a.GetHeight({ 0.0, 0.0, 0.0 });
  const double offsetB = -b.GetHeight({ 0.0, 0.0, 0.0 });
  line.Point = lms3dScale(lms3dAdd(lms3dScale(lms3dCross(b.GetNormal(), cross), offsetA),
                            lms3dScale(lms3dCross(cross, a.GetNormal()), offsetB)),
    1.0 / square);
  line.Direction = lms3dNormalize(cross);
  return true;
}

// Adds the edge of a local map between two planes, if it lies on their line.
void AddEdge(
  const lms3dVector& a, const lms3dVector& b, int first, int second, lms3dFusedPlanes& planes)
{
  Line line;
  if (!Intersect(planes[first].Frame, planes[second].Frame, line))
  {
    return;
  }
  std::array<double, 2> along = {};
  for (int end = 0; end < 2; ++end)
  {
    const lms3dVector v = lms3dSubtract(end == 0 ? a : b, line.Point);
    along[end] = lms3dDot(v, line.Direction);
    if (lms3dGetLength(lms3dSubtract(v, lms3dScale(line.Direction, along[end]))) >
      CreaseReach * planes.GetCell())
    {
      return;
    }
  }
  lms3dCrease& crease = planes[first].Creases[second];
  const auto [from, to] = std::minmax(along[0], along[1]);
  const double gap = CreaseGrowth * planes.GetCell();
  Merge(crease.Seen, from, to, gap);
  if (!Have(crease.Drawn, from, to, gap))
  {
    crease.Drawn = crease.Seen;
    planes[first].HasNewCreases = true;
    planes[second].HasNewCreases = true;
  }
  planes[second].Creases[first] = crease;
}

lms3dCreaseParts ToCells(lms3dCreaseParts parts, double cell)
{
  for (auto& [first, last] : parts)
  {
    first /= cell;
    last /= cell;
  }
  return parts;
}
} // namespace

void lms3dAddCreases(
  const lms3dLocalMap& local, const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes)
{
  // The triangles at each edge of the local map.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> planeOfEdge;
  for (std::size_t triangle = 0; triangle < local.PatchIds.size(); ++triangle)
  {
    const int patch = local.PatchIds[triangle];
    const int plane = patch < 0 ? -1 : planeOfPatch[patch];
    if (plane < 0)
    {
      continue;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t a = local.Mesh.Triangles[triangle][corner];
      const std::uint32_t b = local.Mesh.Triangles[triangle][(corner + 1) % 3];
      const auto [place, isNew] = planeOfEdge.try_emplace(std::minmax(a, b), plane);
      if (isNew || place->second == plane)
      {
        continue;
      }
      AddEdge(local.Mesh.Points[a], local.Mesh.Points[b], std::min(plane, place->second),
        std::max(plane, place->second), planes);
    }
  }
}

std::vector<lms3dCreaseLine> lms3dGetCreaseLines(const lms3dFusedPlanes& planes, int number)
{
  const lms3dFusedPlane& plane = planes[number];
  std::vector<lms3dCreaseLine> lines;
  for (const auto& [other, crease] : plane.Creases)
  {
    Line line;
    const lms3dPlaneFrame& first = planes[std::min(number, other)].Frame;
    const lms3dPlaneFrame& second = planes[std::max(number, other)].Frame;
    if (!Intersect(first, second, line))
    {
      continue;
    }
    lms3dCreaseLine inCells;
    inCells.Point = plane.Frame.ToCells(line.Point);
    const lms3dPoint2 ahead = plane.Frame.ToCells(lms3dAdd(line.Point, line.Direction));
    inCells.Direction = { (ahead[0] - inCells.Point[0]) * planes.GetCell(),
      (ahead[1] - inCells.Point[1]) * planes.GetCell() };
    inCells.Parts = { ToCells(crease.Seen, planes.GetCell()),
      ToCells(crease.Drawn, planes.GetCell()) };
    lines.push_back(inCells);
  }
  return lines;
}
