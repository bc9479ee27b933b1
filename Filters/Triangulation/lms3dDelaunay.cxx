// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dDelaunay.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr const int (&Next)[3] = lms3dLinkedTriangles::Next;
constexpr const int (&Last)[3] = lms3dLinkedTriangles::Last;
// The frame around all points, in sizes of their box: far enough not to spoil shapes within.
constexpr double FrameSize = 64.0;
} // namespace

lms3dDelaunay::lms3dDelaunay(std::vector<lms3dPoint2> points)
  : Points(AddFrame(std::move(points)))
  , FirstOfFrame(static_cast<std::int32_t>(this->Points.size()) - 3)
  , Triangles(static_cast<std::int32_t>(this->Points.size()), this->Points.size())
{
}

std::vector<lms3dPoint2> lms3dDelaunay::AddFrame(std::vector<lms3dPoint2> points)
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
  const double size = FrameSize * std::max(high[0] - low[0], high[1] - low[1]);
  const lms3dPoint2 center = { 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]) };
  points.push_back({ center[0] - size, center[1] - size });
  points.push_back({ center[0] + size, center[1] - size });
  points.push_back({ center[0], center[1] + size });
  return points;
}

// Walks towards the point, across edges that it lies behind. Among triangles that are not Delaunay's,
// since edges are fixed, such a walk may come round; then nothing is found.
lms3dDelaunay::Location lms3dDelaunay::Locate(const lms3dPoint2& point, int near) const
{
  Location location = { near };
  int from = None;
  for (int step = 0; step <= this->Triangles.GetNumberOfTriangles(); ++step)
  {
    const int across = this->FindWayOut(point, location.Triangle, from, location);
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

// An edge that a point lies behind; or None, and where in the triangle it lies. The edge towards the
// triangle that it was looked for before need not be asked.
int lms3dDelaunay::FindWayOut(
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
      this->Suspect(part, point);
    }
  }
  else
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(location.Triangle);
    if (here.IsFixed[location.Edge] || here.Neighbors[location.Edge] == None)
    {
      return false;
    }
    for (int part : this->Triangles.SplitEdge(point, location.Triangle, location.Edge))
    {
      this->Suspect(part, point);
    }
  }
  this->Restore();
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
  if (!this->IsFrame(a))
  {
    return this->FindTriangleAround(a, b, edge);
  }
  // No full turn around a corner of the frame.
  const int other = this->FindTriangleAround(b, a, edge);
  const int triangle = this->Triangles.GetTriangle(other).Neighbors[edge];
  edge = this->Triangles.FindEdge(triangle, other);
  return triangle;
}

int lms3dDelaunay::FindTriangleAround(std::int32_t a, std::int32_t b, int& edge) const
{
  int triangle = this->Triangles.GetTriangleAt(a);
  edge = this->Triangles.FindCorner(triangle, a);
  while (this->Triangles.GetTriangle(triangle).Corners[Next[edge]] != b)
  {
    triangle = this->Triangles.GetTriangle(triangle).Neighbors[Last[edge]];
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

bool lms3dDelaunay::IsBetterFlipped(int triangle, int edge) const
{
  const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
  return here.Neighbors[edge] != None && !here.IsFixed[edge] &&
    lms3dIsInCircle(this->Points[here.Corners[0]], this->Points[here.Corners[1]],
      this->Points[here.Corners[2]], this->Points[this->Triangles.GetOpposite(triangle, edge)]) &&
    this->IsConvex(triangle, edge);
}

void lms3dDelaunay::Restore()
{
  while (!this->Suspects.empty())
  {
    const auto [triangle, apex] = this->Suspects.back();
    this->Suspects.pop_back();
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    const int corner = this->Triangles.FindCorner(triangle, apex);
    const int edge = Next[corner];
    if (here.Corners[corner] != apex || !this->IsBetterFlipped(triangle, edge))
    {
      continue;
    }
    const int other = here.Neighbors[edge];
    const std::int32_t opposite = this->Triangles.GetOpposite(triangle, edge);
    this->Triangles.Flip(triangle, edge);
    // The four outer edges.
    for (int part : { triangle, other })
    {
      this->Suspect(part, apex);
      this->Suspect(part, opposite);
    }
  }
}
