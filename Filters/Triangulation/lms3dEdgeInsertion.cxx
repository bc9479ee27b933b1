// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dEdgeInsertion.h"

namespace
{
constexpr std::int32_t None = lms3dLinkedTriangles::None;
constexpr const int (&Next)[3] = lms3dLinkedTriangles::Next;
constexpr const int (&Last)[3] = lms3dLinkedTriangles::Last;
} // namespace

bool lms3dEdgeInsertion::Insert(std::int32_t a, std::int32_t b)
{
  int triangle;
  int edge;
  if (a == b || this->FixIfPresent(a, b, triangle, edge))
  {
    return a != b;
  }
  if (triangle == None || !this->Untangle(a, b, triangle, edge))
  {
    return false;
  }
  const bool isPresent = this->FixIfPresent(a, b, triangle, edge);
  this->Delaunay.Restore();
  return isPresent;
}

// Fixes the edge from a to b if there is one; otherwise gives the edge around a that it crosses.
bool lms3dEdgeInsertion::FixIfPresent(std::int32_t a, std::int32_t b, int& crossed, int& edge)
{
  crossed = None;
  int triangle = this->Triangles.GetTriangleAt(a);
  const int start = triangle;
  do
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    const int corner = this->Triangles.FindCorner(triangle, a);
    const std::int32_t right = here.Corners[Next[corner]];
    const std::int32_t left = here.Corners[Last[corner]];
    if (right == b)
    {
      this->Triangles.Fix(triangle, corner);
      return true;
    }
    if (this->Delaunay.Orient(a, b, right) < 0 && this->Delaunay.Orient(a, b, left) > 0)
    {
      crossed = triangle;
      edge = Next[corner];
    }
    // Around a, counter-clockwise.
    triangle = here.Neighbors[Last[corner]];
  } while (triangle != start && triangle != None);
  return false;
}

// The edges across the line from a to b; false where one is fixed or a point lies in the way.
bool lms3dEdgeInsertion::FindCrossedEdges(
  std::int32_t a, std::int32_t b, int triangle, int edge, std::deque<Edge>& crossed) const
{
  while (true)
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    if (here.IsFixed[edge])
    {
      return false;
    }
    crossed.push_back({ here.Corners[edge], here.Corners[Next[edge]] });
    const int other = here.Neighbors[edge];
    const int otherEdge = this->Triangles.FindEdge(other, triangle);
    const std::int32_t opposite = this->Triangles.GetApex(other, otherEdge);
    if (opposite == b)
    {
      return true;
    }
    const int side = this->Delaunay.Orient(a, b, opposite);
    if (side == 0)
    {
      return false;
    }
    triangle = other;
    edge = side > 0 ? Next[otherEdge] : Last[otherEdge];
  }
}

// Flips the edges across the line from a to b until none is left.
bool lms3dEdgeInsertion::Untangle(std::int32_t a, std::int32_t b, int triangle, int edge)
{
  std::deque<Edge> crossed;
  if (!this->FindCrossedEdges(a, b, triangle, edge, crossed))
  {
    return false;
  }
  while (!crossed.empty())
  {
    Edge crossing = crossed.front();
    crossed.pop_front();
    if (this->Flip(a, b, crossing))
    {
      crossed.push_back(crossing);
    }
  }
  return true;
}

// Turns an edge across the line from a to b; returns whether it still lies across. An edge that
// cannot be turned yet waits for others; there always is one that can.
bool lms3dEdgeInsertion::Flip(std::int32_t a, std::int32_t b, Edge& crossing)
{
  int side;
  const int triangle = this->Delaunay.FindTriangle(crossing[0], crossing[1], side);
  if (!this->Delaunay.IsConvex(triangle, side))
  {
    return true;
  }
  const int other = this->Triangles.GetTriangle(triangle).Neighbors[side];
  const std::int32_t r = this->Triangles.GetApex(triangle, side);
  const std::int32_t s = this->Triangles.GetOpposite(triangle, side);
  this->Triangles.Flip(triangle, side);
  for (int part : { triangle, other })
  {
    this->Delaunay.Suspect(part, r);
    this->Delaunay.Suspect(part, s);
  }
  crossing = { r, s };
  return r != a && r != b && s != a && s != b &&
    this->Delaunay.Orient(a, b, r) != this->Delaunay.Orient(a, b, s);
}
