// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dEdgeInsertion.h"

namespace
{
constexpr std::int32_t None = lms3dLinkedTriangles::None;
constexpr const int (&Next)[3] = lms3dLinkedTriangles::Next;
constexpr const int (&Previous)[3] = lms3dLinkedTriangles::Previous;
} // namespace

bool lms3dEdgeInsertion::Insert(std::int32_t a, std::int32_t b)
{
  int triangle;
  int edge;
  if (a == b || this->ConstrainIfPresent(a, b))
  {
    return a != b;
  }
  if (!this->FindFirstCrossed(a, b, triangle, edge) ||
    !this->FlipCrossedEdges(a, b, triangle, edge))
  {
    return false;
  }
  const bool isPresent = this->ConstrainIfPresent(a, b);
  this->Delaunay.LegalizeEdges();
  return isPresent;
}

// Calls visit(triangle, corner) for the triangles around a vertex and their corners there,
// counter-clockwise. Stops when a visit returns true, and returns true then.
template <typename Visitor>
bool lms3dEdgeInsertion::FindAround(std::int32_t vertex, const Visitor& visit) const
{
  const int start = this->Triangles.GetTriangleAt(vertex);
  int triangle = start;
  do
  {
    const int corner = this->Triangles.FindCorner(triangle, vertex);
    if (visit(triangle, corner))
    {
      return true;
    }
    triangle = this->Triangles.GetTriangle(triangle).Neighbors[Previous[corner]];
  } while (triangle != start && triangle != None);
  return false;
}

// Constrains the edge from a to b. Returns false if it does not exist.
bool lms3dEdgeInsertion::ConstrainIfPresent(std::int32_t a, std::int32_t b)
{
  return this->FindAround(a,
    [&](int triangle, int corner)
    {
      const bool isFound = this->Triangles.GetTriangle(triangle).Corners[Next[corner]] == b;
      if (isFound)
      {
        this->Triangles.Constrain(triangle, corner);
      }
      return isFound;
    });
}

// Finds a triangle at a and its edge that the line from a to b crosses. Returns false if there is
// none.
bool lms3dEdgeInsertion::FindFirstCrossed(
  std::int32_t a, std::int32_t b, int& crossed, int& edge) const
{
  return this->FindAround(a,
    [&](int triangle, int corner)
    {
      const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
      crossed = triangle;
      edge = Next[corner];
      return this->Delaunay.Orient(a, b, here.Corners[Next[corner]]) < 0 &&
        this->Delaunay.Orient(a, b, here.Corners[Previous[corner]]) > 0;
    });
}

// Finds the edges that cross the line from a to b. Returns false if one is constrained, or if a
// point lies on the line.
bool lms3dEdgeInsertion::FindCrossedEdges(
  std::int32_t a, std::int32_t b, int triangle, int edge, std::deque<Edge>& crossed) const
{
  while (true)
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    if (here.IsConstrained[edge])
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
    edge = side > 0 ? Next[otherEdge] : Previous[otherEdge];
  }
}

// Flips the edges that cross the line from a to b until none is left.
bool lms3dEdgeInsertion::FlipCrossedEdges(std::int32_t a, std::int32_t b, int triangle, int edge)
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

// Flips an edge that crosses the line from a to b. Returns whether it still crosses. An edge that
// cannot be flipped yet has to wait; there always is one that can.
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
    this->Delaunay.QueueEdge(part, r);
    this->Delaunay.QueueEdge(part, s);
  }
  crossing = { r, s };
  return r != a && r != b && s != a && s != b &&
    this->Delaunay.Orient(a, b, r) != this->Delaunay.Orient(a, b, s);
}
