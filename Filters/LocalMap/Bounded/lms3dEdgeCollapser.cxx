// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dEdgeCollapser.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dVertexFit.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
// The smallest cosine between two corners of a new triangle, as the sensor sees them.
constexpr double MinimumCosine = 0.7;
// The smallest height of a new triangle as the sensor sees it, as a share of its longest edge, and
// the same on a curved surface.
constexpr double MinimumHeight = 0.02;
constexpr double MinimumHeightIfCurved = 0.005;
// Unless the surface is curved, large maps end with the first round in which fewer of its edges
// collapse: many more rounds would follow, and hardly any triangle would go.
constexpr double MinimumShare = 0.1;
constexpr std::size_t LargeRound = 100;
// The number of edges that a thread tries at least.
constexpr std::size_t EdgesOfTask = 4;

// Calls visit(next, last) for each triangle that an edge leaves when it collapses. Stops when a
// visit returns false, and returns false then.
template <typename Visitor>
bool ForEachSide(
  const lms3dVertexStars& stars, std::int32_t from, std::int32_t to, const Visitor& visit)
{
  const auto visitOf = [&](std::int32_t vertex, std::int32_t other)
  {
    return stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      { return next == other || last == other || visit(next, last); });
  };
  return visitOf(from, to) && (!stars.GetVertex(to).IsFree || visitOf(to, from));
}
} // namespace

lms3dEdgeCollapser::lms3dEdgeCollapser(
  const lms3dBeamDemands& demands, bool isCurved, lms3dVertexStars& stars)
  : Demands(demands)
  , IsCurved(isCurved)
  , Stars(stars)
{
}

bool lms3dEdgeCollapser::Run(
  const lms3dBeamDemands& demands, bool isCurved, lms3dVertexStars& stars)
{
  return lms3dEdgeCollapser(demands, isCurved, stars).Run();
}

// Whether the vertex that replaces an edge sees all sides of the star, and no new triangle is a
// sliver or very large.
bool lms3dEdgeCollapser::HasSoundShape(const Edge& edge, const lms3dTriangleCorner& corner) const
{
  const double minimumHeight = this->IsCurved ? MinimumHeightIfCurved : MinimumHeight;
  return ForEachSide(this->Stars, edge.From, edge.To,
    [&](std::int32_t next, std::int32_t last)
    {
      const lms3dVector& a = corner.Position;
      const lms3dVector& b = this->Stars.GetVertex(next).Corner.Position;
      const lms3dVector& c = this->Stars.GetVertex(last).Corner.Position;
      const lms3dVector opposite = lms3dCross(c, b);
      const double cosine = std::min(lms3dDot(a, b), lms3dDot(a, c));
      const double longest =
        std::max(lms3dDot(opposite, opposite), std::max(0.0, 1.0 - cosine * cosine));
      return cosine > MinimumCosine && lms3dDot(opposite, a) > minimumHeight * longest;
    });
}

// Whether an edge can collapse, and the vertex that replaces it.
lms3dEdgeCollapser::Result lms3dEdgeCollapser::TryToCollapse(const Edge& edge) const
{
  const lms3dVertexStars& stars = this->Stars;
  const lms3dVertexStars::Vertex& to = stars.GetVertex(edge.To);
  Result result = { false, lms3dNormalize(lms3dCollapsibleEdges::GetBestPlace(stars, edge)),
    to.Inverse };
  const lms3dTriangleCorner corner = to.IsFree ? lms3dTriangleCorner(result.Direction) : to.Corner;
  if (!this->HasSoundShape(edge, corner) || !stars.AreLinked(edge.From, edge.To))
  {
    return result;
  }
  if (!to.IsFree)
  {
    result.CanCollapse = ForEachSide(stars, edge.From, edge.To,
      [&](std::int32_t next, std::int32_t last)
      {
        return lms3dVertexFit::Allows(
          this->Demands, corner, result.Inverse, lms3dVertexFit::GetSide(stars, next, last));
      });
    return result;
  }
  lms3dVertexFit fit(this->Demands);
  if (ForEachSide(stars, edge.From, edge.To,
        [&](std::int32_t next, std::int32_t last)
        { return fit.Add(corner, lms3dVertexFit::GetSide(stars, next, last)); }) &&
    fit.IsDetermined())
  {
    result.Inverse = fit.GetInverse();
    result.CanCollapse = result.Inverse > 0.0;
  }
  return result;
}

bool lms3dEdgeCollapser::Run()
{
  bool isChanged = false;
  lms3dCollapsibleEdges edges(this->Stars);
  while (true)
  {
    const std::vector<Edge> selected = edges.TakeIndependent();
    std::vector<std::uint8_t> hasCollapsed(selected.size());
    lms3dForEachInTasks(selected.size(), EdgesOfTask,
      [&](std::size_t i) { hasCollapsed[i] = this->Collapse(selected[i]); });
    std::vector<std::int32_t> changed;
    std::vector<std::int32_t> gone;
    for (std::size_t i = 0; i < selected.size(); ++i)
    {
      if (hasCollapsed[i])
      {
        changed.push_back(selected[i].To);
        gone.push_back(selected[i].From);
      }
    }
    isChanged |= !changed.empty();
    if (this->IsLast(selected.size(), changed.size()))
    {
      return isChanged;
    }
    edges.Update(changed, gone);
  }
}

// Whether a round is the last one, by its edges and by how many of them have collapsed.
bool lms3dEdgeCollapser::IsLast(std::size_t selected, std::size_t collapsed) const
{
  return selected == 0 ||
    (!this->IsCurved && selected >= LargeRound &&
      static_cast<double>(collapsed) < MinimumShare * static_cast<double>(selected));
}

// Collapses an edge if it can, and returns whether it has. Otherwise it is not tried again until
// its star changes.
bool lms3dEdgeCollapser::Collapse(const Edge& edge)
{
  const Result result = this->TryToCollapse(edge);
  if (result.CanCollapse)
  {
    this->Stars.Collapse(edge.From, edge.To, result.Direction, result.Inverse);
  }
  else
  {
    this->Stars.SetRigid(edge.From, edge.To);
  }
  return result.CanCollapse;
}
