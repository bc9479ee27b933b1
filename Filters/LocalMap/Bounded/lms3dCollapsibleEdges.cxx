// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dCollapsibleEdges.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace
{
bool IsCheaper(const lms3dCollapsibleEdges::Edge& a, const lms3dCollapsibleEdges::Edge& b)
{
  return a.Cost != b.Cost ? a.Cost < b.Cost
                          : std::tie(a.From, a.To, a.Side) < std::tie(b.From, b.To, b.Side);
}

lms3dQuadric GetQuadric(const lms3dVertexStars& stars, const lms3dCollapsibleEdges::Edge& edge)
{
  lms3dQuadric quadric = stars.GetVertex(edge.From).Quadric;
  quadric.Add(stars.GetVertex(edge.To).Quadric);
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

// Both ends of an edge have a triangle on its left side, so each edge is found from its end with the smaller number.
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
  tbb::parallel_for(std::size_t(0), edges.size(),
    [&](std::size_t i)
    {
      const lms3dQuadric quadric = GetQuadric(this->Stars, edges[i]);
      const double cost = quadric.GetValue(GetPlace(this->Stars, edges[i], quadric));
      edges[i].Cost = std::isfinite(cost) ? cost : 0.0;
    });
  tbb::parallel_sort(edges.begin(), edges.end(), IsCheaper);
}

std::vector<lms3dCollapsibleEdges::Edge> lms3dCollapsibleEdges::SelectIndependent() const
{
  std::vector<std::uint8_t> isUsed(this->Stars.GetNumberOfVertices(), 0);
  std::vector<Edge> selected;
  for (const Edge& edge : this->Sorted)
  {
    // Decides for most edges, and is quick.
    if (isUsed[edge.From] || isUsed[edge.To])
    {
      continue;
    }
    const auto forEachVertex = [&](const auto& visit)
    {
      const auto visitBoth = [&](std::int32_t, std::int32_t next, std::int32_t last)
      { return visit(next) && visit(last); };
      return this->Stars.ForEachTriangle(edge.From, visitBoth) &&
        this->Stars.ForEachTriangle(edge.To, visitBoth);
    };
    if (forEachVertex([&](std::int32_t vertex) { return !isUsed[vertex]; }))
    {
      forEachVertex(
        [&](std::int32_t vertex)
        {
          isUsed[vertex] = 1;
          return true;
        });
      selected.push_back(edge);
    }
  }
  return selected;
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
  const auto isOutdated = [this](const Edge& edge)
  {
    return this->IsChanged[edge.From] || this->IsChanged[edge.To] ||
      this->Stars.GetTriangles()[edge.Side / 3].IsRigid[edge.Side % 3];
  };
  this->Sorted.erase(
    std::remove_if(this->Sorted.begin(), this->Sorted.end(), isOutdated), this->Sorted.end());
  std::vector<Edge> merged;
  merged.reserve(this->Sorted.size() + edges.size());
  std::merge(this->Sorted.begin(), this->Sorted.end(), edges.begin(), edges.end(),
    std::back_inserter(merged), IsCheaper);
  this->Sorted = std::move(merged);
  for (std::int32_t vertex : marked)
  {
    this->IsChanged[vertex] = 0;
  }
}
