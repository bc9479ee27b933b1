// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dOutlineCrossings.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
using Edge = std::array<lms3dPoint2, 2>;

double GetLeft(const Edge& edge)
{
  return std::min(edge[0][0], edge[1][0]);
}

double GetRight(const Edge& edge)
{
  return std::max(edge[0][0], edge[1][0]);
}

bool HasArea(const lms3dLoop& loop)
{
  return loop.size() >= 3;
}

// The edges of all loops, from left to right.
std::vector<Edge> SortEdges(const std::vector<lms3dLoop>& loops)
{
  std::vector<Edge> edges;
  for (const lms3dLoop& loop : loops)
  {
    for (std::size_t i = 0; HasArea(loop) && i < loop.size(); ++i)
    {
      edges.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b) { return GetLeft(a) < GetLeft(b); });
  return edges;
}

int GetOrientation(const Edge& edge, const lms3dPoint2& point)
{
  return lms3dGetOrientation(edge[0], edge[1], point);
}

// Whether a point lies on an edge, but at neither end.
bool IsOn(const Edge& edge, const lms3dPoint2& point)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto [low, high] = std::minmax(edge[0][axis], edge[1][axis]);
    if (point[axis] < low || point[axis] > high)
    {
      return false;
    }
  }
  return point != edge[0] && point != edge[1] && GetOrientation(edge, point) == 0;
}

lms3dPoint2 Intersect(const Edge& a, const Edge& b)
{
  const double au = a[1][0] - a[0][0];
  const double av = a[1][1] - a[0][1];
  const double bu = b[1][0] - b[0][0];
  const double bv = b[1][1] - b[0][1];
  const double along = ((b[0][0] - a[0][0]) * bv - (b[0][1] - a[0][1]) * bu) / (au * bv - av * bu);
  return { a[0][0] + along * au, a[0][1] + along * av };
}

// Whether two edges are apart along the second axis.
bool AreApart(const Edge& a, const Edge& b)
{
  return std::max(a[0][1], a[1][1]) < std::min(b[0][1], b[1][1]) ||
    std::max(b[0][1], b[1][1]) < std::min(a[0][1], a[1][1]);
}

void AddCrossings(const Edge& a, const Edge& b, std::vector<lms3dPoint2>& crossings)
{
  if (AreApart(a, b))
  {
    return;
  }
  if (std::minmax(a[0], a[1]) == std::minmax(b[0], b[1]))
  {
    crossings.insert(crossings.end(), a.begin(), a.end());
  }
  for (int end = 0; end < 2; ++end)
  {
    if (IsOn(a, b[end]))
    {
      crossings.push_back(b[end]);
    }
    if (IsOn(b, a[end]))
    {
      crossings.push_back(a[end]);
    }
  }
  if (GetOrientation(a, b[0]) * GetOrientation(a, b[1]) < 0 &&
    GetOrientation(b, a[0]) * GetOrientation(b, a[1]) < 0)
  {
    crossings.push_back(Intersect(a, b));
  }
}

// The points at which there are several corners.
std::vector<lms3dPoint2> FindSharedCorners(const std::vector<lms3dLoop>& loops)
{
  std::vector<lms3dPoint2> corners;
  for (const lms3dLoop& loop : loops)
  {
    corners.insert(corners.end(), loop.begin(), HasArea(loop) ? loop.end() : loop.begin());
  }
  std::sort(corners.begin(), corners.end());
  std::vector<lms3dPoint2> shared;
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    if (corners[i] == corners[i - 1])
    {
      shared.push_back(corners[i]);
    }
  }
  return shared;
}
} // namespace

std::vector<lms3dPoint2> lms3dFindCrossingEdges(const std::vector<lms3dLoop>& loops)
{
  const std::vector<Edge> edges = SortEdges(loops);
  std::vector<lms3dPoint2> crossings;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    for (std::size_t j = i + 1; j < edges.size() && GetLeft(edges[j]) <= GetRight(edges[i]); ++j)
    {
      AddCrossings(edges[i], edges[j], crossings);
    }
  }
  return crossings;
}

std::vector<lms3dPoint2> lms3dFindCrossings(const std::vector<lms3dLoop>& loops)
{
  const std::vector<lms3dPoint2> crossings = lms3dFindCrossingEdges(loops);
  return crossings.empty() ? FindSharedCorners(loops) : crossings;
}
