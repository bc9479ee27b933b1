// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dCollapsibleEdges.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace
{
// The number of edges whose costs a thread computes at least.
constexpr std::size_t EdgesOfTask = 64;

bool IsCheaper(const lms3dCollapsibleEdges::Edge& a, const lms3dCollapsibleEdges::Edge& b)
{
  return a.Cost != b.Cost ? a.Cost < b.Cost
                          : std::tie(a.From, a.To, a.Side) < std::tie(b.From, b.To, b.Side);
}

lms3dQuadric GetQuadric(const lms3dVertexStars& stars, const lms3dCollapsibleEdges::Edge& edge)
{
  lms3dQuadric quadric = stars.GetQuadric(edge.From);
  quadric.Add(stars.GetQuadric(edge.To));
  return quadric;
}

lms3dVector GetPlace(const lms3dVertexStars& stars, const lms3dCollapsibleEdges::Edge& edge,
  const lms3dQuadric& quadric)
{
  if (!stars.GetVertex(edge.To).IsFree)
  {
    return stars.GetPosition(edge.To);
  }
  // The middle if the smallest value cannot be computed.
  const lms3dVector best = quadric.GetMinimum();
  return lms3dIsFinite(best)
    ? best
    : lms3dScale(lms3dAdd(stars.GetPosition(edge.From), stars.GetPosition(edge.To)), 0.5);
}
} // namespace

lms3dCollapsibleEdges::lms3dCollapsibleEdges(const lms3dVertexStars& stars)
  : Stars(stars)
  , IsChanged(stars.GetNumberOfVertices(), 1)
  , IsFound(stars.GetTriangles().size(), 0)
  , Uses(stars.GetNumberOfVertices(), 0)
{
  for (std::size_t i = 0; i < stars.GetTriangles().size(); ++i)
  {
    this->AppendEdges(static_cast<std::int32_t>(i), this->Sorted);
  }
  std::fill(this->IsChanged.begin(), this->IsChanged.end(), 0);
  this->Sort(this->Sorted);
}

lms3dVector lms3dCollapsibleEdges::GetBestPlace(const lms3dVertexStars& stars, const Edge& edge)
{
  return GetPlace(stars, edge, GetQuadric(stars, edge));
}

// Both ends of an edge have a triangle on its left side, so each edge is found from its end with
// the smaller number.
void lms3dCollapsibleEdges::AppendEdges(std::int32_t number, std::vector<Edge>& edges) const
{
  const lms3dVertexStars::Triangle& triangle = this->Stars.GetTriangles()[number];
  for (int i = 0; i < 3 && !triangle.IsRemoved; ++i)
  {
    std::int32_t from = triangle.Corners[i];
    std::int32_t to = triangle.Corners[(i + 1) % 3];
    const bool isFromFree = this->Stars.GetVertex(from).IsFree;
    if (triangle.IsRigid[i] || from > to || !(isFromFree || this->Stars.GetVertex(to).IsFree) ||
      !(this->IsChanged[from] || this->IsChanged[to]))
    {
      continue;
    }
    if (!isFromFree)
    {
      std::swap(from, to);
    }
    edges.push_back({ 0.0, from, to, 3 * number + i });
  }
}

// Computes the costs, too.
void lms3dCollapsibleEdges::Sort(std::vector<Edge>& edges) const
{
  lms3dForEachInTasks(edges.size(), EdgesOfTask,
    [&](std::size_t i)
    {
      const lms3dQuadric quadric = GetQuadric(this->Stars, edges[i]);
      const double cost = quadric.GetValue(GetPlace(this->Stars, edges[i], quadric));
      edges[i].Cost = std::isfinite(cost) ? cost : 0.0;
    });
  tbb::parallel_sort(edges.begin(), edges.end(), IsCheaper);
}

std::vector<lms3dCollapsibleEdges::Edge> lms3dCollapsibleEdges::TakeIndependent()
{
  ++this->Selection;
  std::vector<Edge> selected;
  const auto take = [&](const Edge& edge)
  {
    const bool isTaken = this->AreFree(edge);
    if (isTaken)
    {
      this->Use(edge);
      selected.push_back(edge);
    }
    return isTaken;
  };
  // Looks at each edge once, in order.
  std::size_t kept = 0;
  for (const Edge& edge : this->Sorted)
  {
    if (!take(edge))
    {
      this->Sorted[kept] = edge;
      ++kept;
    }
  }
  this->Sorted.resize(kept);
  return selected;
}

// Whether no vertex of the stars of an edge is used.
bool lms3dCollapsibleEdges::AreFree(const Edge& edge) const
{
  const auto isFree = [this](std::int32_t vertex) { return this->Uses[vertex] != this->Selection; };
  const auto areFree = [&](std::int32_t, std::int32_t next, std::int32_t last)
  { return isFree(next) && isFree(last); };
  // The ends decide for most edges, and are quick.
  return isFree(edge.From) && isFree(edge.To) && this->Stars.ForEachTriangle(edge.From, areFree) &&
    this->Stars.ForEachTriangle(edge.To, areFree);
}

// Each end belongs to the star of the other.
void lms3dCollapsibleEdges::Use(const Edge& edge)
{
  const auto use = [this](std::int32_t, std::int32_t next, std::int32_t last)
  {
    this->Uses[next] = this->Selection;
    this->Uses[last] = this->Selection;
    return true;
  };
  this->Stars.ForEachTriangle(edge.From, use);
  this->Stars.ForEachTriangle(edge.To, use);
}

void lms3dCollapsibleEdges::MarkChanged(std::int32_t vertex, std::vector<std::int32_t>& marked)
{
  if (!this->IsChanged[vertex])
  {
    this->IsChanged[vertex] = 1;
    marked.push_back(vertex);
  }
}

// The triangles at vertices, each once.
std::vector<std::int32_t> lms3dCollapsibleEdges::FindTriangles(
  const std::vector<std::int32_t>& vertices)
{
  std::vector<std::int32_t> triangles;
  for (std::int32_t vertex : vertices)
  {
    for (std::int32_t triangle : this->Stars.GetVertex(vertex).Triangles)
    {
      if (!this->IsFound[triangle])
      {
        this->IsFound[triangle] = 1;
        triangles.push_back(triangle);
      }
    }
  }
  for (std::int32_t triangle : triangles)
  {
    this->IsFound[triangle] = 0;
  }
  return triangles;
}

void lms3dCollapsibleEdges::Update(
  const std::vector<std::int32_t>& changed, const std::vector<std::int32_t>& gone)
{
  std::vector<std::int32_t> marked;
  for (std::int32_t vertex : gone)
  {
    this->MarkChanged(vertex, marked);
  }
  // The quadrics of the neighbours have changed, too.
  for (std::int32_t vertex : changed)
  {
    this->MarkChanged(vertex, marked);
    this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        this->MarkChanged(next, marked);
        this->MarkChanged(last, marked);
        return true;
      });
  }
  std::vector<Edge> edges;
  for (std::int32_t triangle : this->FindTriangles(marked))
  {
    this->AppendEdges(triangle, edges);
  }
  this->Sort(edges);
  this->MergeIn(edges);
  for (std::int32_t vertex : marked)
  {
    this->IsChanged[vertex] = 0;
  }
}

// Replaces the edges at changed vertices by these, which are sorted.
void lms3dCollapsibleEdges::MergeIn(const std::vector<Edge>& edges)
{
  this->Merged.clear();
  this->Merged.reserve(this->Sorted.size() + edges.size());
  auto next = edges.begin();
  for (const Edge& edge : this->Sorted)
  {
    if (this->IsChanged[edge.From] || this->IsChanged[edge.To])
    {
      continue;
    }
    while (next != edges.end() && IsCheaper(*next, edge))
    {
      this->Merged.push_back(*next++);
    }
    this->Merged.push_back(edge);
  }
  this->Merged.insert(this->Merged.end(), next, edges.end());
  std::swap(this->Sorted, this->Merged);
}
