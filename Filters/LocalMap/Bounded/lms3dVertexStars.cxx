// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace
{
// The weight of a vertex's own place in its quadric, as a share of the area around it. It decides
// where planes leave the place open.
constexpr double PointWeight = 1e-3;
constexpr int CommonNeighbors = 2;
} // namespace

lms3dVertexStars::lms3dVertexStars(const lms3dBoundedMap& map)
{
  this->Vertices.reserve(map.Points.size());
  for (const lms3dVector& point : map.Points)
  {
    const double inverse = 1.0 / lms3dGetLength(point);
    this->Vertices.push_back(
      { lms3dTriangleCorner(lms3dScale(point, inverse)), inverse, false, false, false, {} });
  }
  std::vector<int> counts(map.Points.size(), 0);
  for (const std::array<std::int32_t, 3>& corners : map.Triangles)
  {
    for (std::int32_t corner : corners)
    {
      ++counts[corner];
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    this->Vertices[i].Triangles.reserve(counts[i]);
  }
  this->Triangles.reserve(map.Triangles.size());
  for (const std::array<std::int32_t, 3>& corners : map.Triangles)
  {
    for (std::int32_t corner : corners)
    {
      this->Vertices[corner].Triangles.push_back(static_cast<std::int32_t>(this->Triangles.size()));
    }
    this->Triangles.push_back({ corners });
    this->Triangles.back().IsStrip = map.PatchIds[this->Triangles.size() - 1] < 0;
  }
}

// Only an edge from a free vertex has a cost, and both of its ends count.
void lms3dVertexStars::SetFree(const std::vector<std::uint8_t>& isFree)
{
  this->Quadrics.resize(this->Vertices.size());
  for (std::size_t i = 0; i < isFree.size(); ++i)
  {
    this->Vertices[i].IsFree = isFree[i] != 0;
  }
  tbb::parallel_for(0, this->GetNumberOfVertices(),
    [this](int i)
    {
      if (this->IsAtFree(i))
      {
        this->UpdateQuadric(i);
      }
    });
}

// Whether a vertex or a neighbour of it is free.
bool lms3dVertexStars::IsAtFree(std::int32_t vertex) const
{
  const auto isFixed = [this](std::int32_t number) { return !this->Vertices[number].IsFree; };
  return !isFixed(vertex) ||
    !this->ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      { return isFixed(next) && isFixed(last); });
}

void lms3dVertexStars::UpdateQuadric(std::int32_t vertex)
{
  lms3dQuadric quadric;
  double area = 0.0;
  const lms3dVector at = this->GetPosition(vertex);
  this->ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t last)
    {
      const lms3dVector b = this->GetPosition(next);
      const lms3dVector c = this->GetPosition(last);
      quadric.AddTriangle(at, b, c);
      area += lms3dGetLength(lms3dCross(lms3dSubtract(b, at), lms3dSubtract(c, at)));
      return true;
    });
  quadric.AddPoint(at, PointWeight * area);
  this->Quadrics[vertex] = quadric;
}

void lms3dVertexStars::SetInverse(std::int32_t vertex, double inverse)
{
  this->Vertices[vertex].Inverse = inverse;
  this->Vertices[vertex].HasMoved = true;
}

lms3dStarSides lms3dVertexStars::GetSides(std::int32_t vertex) const
{
  lms3dStarSides sides;
  this->ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t last)
    {
      sides.Add(next, last);
      return true;
    });
  return sides;
}

bool lms3dVertexStars::FindBorder(std::int32_t vertex, Border& border) const
{
  return this->GetSides(vertex).FindBorder(border);
}

bool lms3dVertexStars::FindBorderOfPatches(std::int32_t vertex, Border& border) const
{
  lms3dStarSides sides;
  this->ForEachTriangle(vertex,
    [&](std::int32_t number, std::int32_t next, std::int32_t last)
    {
      if (!this->Triangles[number].IsStrip)
      {
        sides.Add(next, last);
      }
      return true;
    });
  return sides.FindBorder(border);
}

std::vector<std::int32_t> lms3dVertexStars::GetNeighbors(std::int32_t vertex) const
{
  std::vector<std::int32_t> neighbors;
  this->ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t last)
    {
      neighbors.push_back(next);
      neighbors.push_back(last);
      return true;
    });
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  return neighbors;
}

bool lms3dVertexStars::AreLinked(std::int32_t a, std::int32_t b) const
{
  return this->GetSides(a).CountCommon(this->GetSides(b)) == CommonNeighbors;
}

void lms3dVertexStars::SetRigid(std::int32_t a, std::int32_t b)
{
  for (std::int32_t number : this->Vertices[a].Triangles)
  {
    Triangle& triangle = this->Triangles[number];
    for (int i = 0; i < 3; ++i)
    {
      const std::int32_t from = triangle.Corners[i];
      const std::int32_t to = triangle.Corners[(i + 1) % 3];
      triangle.IsRigid[i] = triangle.IsRigid[i] || (from == a && to == b) || (from == b && to == a);
    }
  }
}

void lms3dVertexStars::ReleaseChanged()
{
  for (Triangle& triangle : this->Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangle.IsRigid[i] = triangle.IsRigid[i] &&
        !(this->Vertices[triangle.Corners[i]].IsChanged &&
          this->Vertices[triangle.Corners[(i + 1) % 3]].IsChanged);
    }
  }
}

void lms3dVertexStars::Remove(std::int32_t triangle)
{
  this->Triangles[triangle].IsRemoved = true;
  for (std::int32_t corner : this->Triangles[triangle].Corners)
  {
    std::vector<std::int32_t>& around = this->Vertices[corner].Triangles;
    around.erase(std::find(around.begin(), around.end(), triangle));
  }
}

void lms3dVertexStars::Merge(std::int32_t from, std::int32_t to)
{
  const std::vector<std::int32_t> moved = this->Vertices[from].Triangles;
  for (std::int32_t number : moved)
  {
    std::array<std::int32_t, 3>& corners = this->Triangles[number].Corners;
    if (std::find(corners.begin(), corners.end(), to) != corners.end())
    {
      this->Remove(number);
      continue;
    }
    std::replace(corners.begin(), corners.end(), from, to);
    this->Vertices[to].Triangles.push_back(number);
  }
  this->Vertices[from].Triangles.clear();
}

void lms3dVertexStars::Flip(const Quad& quad)
{
  const auto take = [this](std::int32_t triangle, std::int32_t from, std::int32_t to)
  {
    std::vector<std::int32_t>& around = this->Vertices[from].Triangles;
    around.erase(std::find(around.begin(), around.end(), triangle));
    this->Vertices[to].Triangles.push_back(triangle);
  };
  this->Triangles[quad.LeftTriangle].Corners = { quad.Left, quad.From, quad.Right };
  this->Triangles[quad.RightTriangle].Corners = { quad.Right, quad.To, quad.Left };
  take(quad.LeftTriangle, quad.To, quad.Right);
  take(quad.RightTriangle, quad.From, quad.Left);
}

void lms3dVertexStars::Collapse(
  std::int32_t from, std::int32_t to, const lms3dVector& direction, double inverse)
{
  this->Merge(from, to);
  if (this->Vertices[to].IsFree)
  {
    this->Vertices[to].Corner = lms3dTriangleCorner(direction);
    this->Vertices[to].Inverse = inverse;
    this->Vertices[to].HasMoved = true;
  }
  this->UpdateStar(to);
}

void lms3dVertexStars::UpdateStar(std::int32_t vertex)
{
  std::vector<std::int32_t> changed = this->GetNeighbors(vertex);
  changed.push_back(vertex);
  for (std::int32_t number : changed)
  {
    this->UpdateQuadric(number);
    this->Vertices[number].IsChanged = true;
  }
  for (std::int32_t number : this->Vertices[vertex].Triangles)
  {
    this->Triangles[number].IsRigid = { false, false, false };
  }
}
