// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dDelaunay.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr const int (&Next)[3] = lms3dLinkedTriangles::Next;
constexpr const int (&Previous)[3] = lms3dLinkedTriangles::Previous;
// The size of the super-triangle, in sizes of the points' bounding box. It is far enough away not
// to change the triangles of the points.
constexpr double SuperTriangleSize = 64.0;
} // namespace

lms3dDelaunay::lms3dDelaunay(std::vector<lms3dPoint2> points)
  : Points(AddSuperTriangle(std::move(points)))
  , FirstOfSuperTriangle(static_cast<std::int32_t>(this->Points.size()) - 3)
  , Triangles(static_cast<std::int32_t>(this->Points.size()), this->Points.size())
{
}

std::vector<lms3dPoint2> lms3dDelaunay::AddSuperTriangle(std::vector<lms3dPoint2> points)
{
  lms3dPoint2 low = points.front();
  lms3dPoint2 high = low;
  for (const lms3dPoint2& point : points)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const double size = SuperTriangleSize * std::max(high[0] - low[0], high[1] - low[1]);
  const lms3dPoint2 center = { 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]) };
  points.push_back({ center[0] - size, center[1] - size });
  points.push_back({ center[0] + size, center[1] - size });
  points.push_back({ center[0], center[1] + size });
  return points;
}

// Walks towards the point, across edges behind which it lies. Constrained edges can make such a
// walk go in circles; then the location has no triangle.
lms3dDelaunay::Location lms3dDelaunay::Locate(const lms3dPoint2& point, int near) const
{
  Location location = { near };
  int from = None;
  for (int step = 0; step <= this->Triangles.GetNumberOfTriangles(); ++step)
  {
    const int across = this->FindExitEdge(point, location.Triangle, from, location);
    if (across == None)
    {
      return location;
    }
    from = location.Triangle;
    location = { this->Triangles.GetTriangle(from).Neighbors[across] };
    if (location.Triangle == None)
    {
      return location;
    }
  }
  return { None };
}

// Returns an edge behind which a point lies. If there is none, returns None and sets where in the
// triangle the point lies. The edge to the triangle `from`, where the walk came from, is skipped.
int lms3dDelaunay::FindExitEdge(
  const lms3dPoint2& point, int triangle, int from, Location& location) const
{
  const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
  for (int edge = 0; edge < 3; ++edge)
  {
    if (from != None && here.Neighbors[edge] == from)
    {
      continue;
    }
    const int side = lms3dGetOrientation(
      this->Points[here.Corners[edge]], this->Points[here.Corners[Next[edge]]], point);
    if (side < 0)
    {
      return edge;
    }
    if (side == 0)
    {
      location.IsCorner = location.Edge != None;
      location.Edge = edge;
    }
  }
  return None;
}

bool lms3dDelaunay::Insert(std::int32_t point, int near)
{
  return this->InsertAt(point, this->Locate(this->Points[point], near));
}

bool lms3dDelaunay::InsertAt(std::int32_t point, const Location& location)
{
  if (location.Triangle == None || location.IsCorner)
  {
    return false;
  }
  if (location.Edge == None)
  {
    for (int part : this->Triangles.SplitTriangle(point, location.Triangle))
    {
      this->QueueEdge(part, point);
    }
  }
  else
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(location.Triangle);
    if (here.IsConstrained[location.Edge] || here.Neighbors[location.Edge] == None)
    {
      return false;
    }
    for (int part : this->Triangles.SplitEdge(point, location.Triangle, location.Edge))
    {
      this->QueueEdge(part, point);
    }
  }
  this->LegalizeEdges();
  return true;
}

std::int32_t lms3dDelaunay::InsertInside(const lms3dPoint2& point, int near)
{
  const Location location = this->Locate(point, near);
  if (location.Triangle == None || !this->Triangles.GetTriangle(location.Triangle).IsInside)
  {
    return None;
  }
  const std::int32_t number = static_cast<std::int32_t>(this->Points.size());
  this->Points.push_back(point);
  this->Triangles.AddPoint();
  if (!this->InsertAt(number, location))
  {
    this->Points.pop_back();
    this->Triangles.RemovePoint();
    return None;
  }
  return number;
}

int lms3dDelaunay::FindTriangle(std::int32_t a, std::int32_t b, int& edge) const
{
  if (!this->IsSuperTriangleCorner(a))
  {
    return this->FindTriangleAt(a, b, edge);
  }
  // The triangles at a corner of the super-triangle do not surround it.
  const int other = this->FindTriangleAt(b, a, edge);
  const int triangle = this->Triangles.GetTriangle(other).Neighbors[edge];
  edge = this->Triangles.FindEdge(triangle, other);
  return triangle;
}

int lms3dDelaunay::FindTriangleAt(std::int32_t a, std::int32_t b, int& edge) const
{
  int triangle = this->Triangles.GetTriangleAt(a);
  edge = this->Triangles.FindCorner(triangle, a);
  while (this->Triangles.GetTriangle(triangle).Corners[Next[edge]] != b)
  {
    triangle = this->Triangles.GetTriangle(triangle).Neighbors[Previous[edge]];
    edge = this->Triangles.FindCorner(triangle, a);
  }
  return triangle;
}

bool lms3dDelaunay::IsConvex(int triangle, int edge) const
{
  const std::array<std::int32_t, 3>& corners = this->Triangles.GetTriangle(triangle).Corners;
  const std::int32_t apex = this->Triangles.GetApex(triangle, edge);
  const std::int32_t opposite = this->Triangles.GetOpposite(triangle, edge);
  return this->Orient(apex, corners[edge], opposite) > 0 &&
    this->Orient(opposite, corners[Next[edge]], apex) > 0;
}

bool lms3dDelaunay::IsIllegal(int triangle, int edge) const
{
  const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
  return here.Neighbors[edge] != None && !here.IsConstrained[edge] &&
    lms3dIsInCircle(this->Points[here.Corners[0]], this->Points[here.Corners[1]],
      this->Points[here.Corners[2]], this->Points[this->Triangles.GetOpposite(triangle, edge)]) &&
    this->IsConvex(triangle, edge);
}

void lms3dDelaunay::LegalizeEdges()
{
  while (!this->Pending.empty())
  {
    const auto [triangle, apex] = this->Pending.back();
    this->Pending.pop_back();
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    const int corner = this->Triangles.FindCorner(triangle, apex);
    const int edge = Next[corner];
    if (here.Corners[corner] != apex || !this->IsIllegal(triangle, edge))
    {
      continue;
    }
    const int other = here.Neighbors[edge];
    const std::int32_t opposite = this->Triangles.GetOpposite(triangle, edge);
    this->Triangles.Flip(triangle, edge);
    // The four outer edges.
    for (int part : { triangle, other })
    {
      this->QueueEdge(part, apex);
      this->QueueEdge(part, opposite);
    }
  }
}
