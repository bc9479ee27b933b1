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
  if (a == b || this->ConstrainIfPresent(a, b, triangle, edge))
  {
    return a != b;
  }
  if (triangle == None || !this->FlipCrossedEdges(a, b, triangle, edge))
  {
    return false;
  }
  const bool isPresent = this->ConstrainIfPresent(a, b, triangle, edge);
  this->Delaunay.LegalizeEdges();
  return isPresent;
}

// Constrains the edge from a to b if it exists. Otherwise sets a triangle at a and its edge that the line
// from a to b crosses.
bool lms3dEdgeInsertion::ConstrainIfPresent(std::int32_t a, std::int32_t b, int& crossed, int& edge)
{
  crossed = None;
  int triangle = this->Triangles.GetTriangleAt(a);
  const int start = triangle;
  do
  {
    const lms3dLinkedTriangles::Triangle& here = this->Triangles.GetTriangle(triangle);
    const int corner = this->Triangles.FindCorner(triangle, a);
    const std::int32_t right = here.Corners[Next[corner]];
    const std::int32_t left = here.Corners[Previous[corner]];
    if (right == b)
    {
      this->Triangles.Constrain(triangle, corner);
      return true;
    }
    if (this->Delaunay.Orient(a, b, right) < 0 && this->Delaunay.Orient(a, b, left) > 0)
    {
      crossed = triangle;
      edge = Next[corner];
    }
    // Around a, counter-clockwise.
    triangle = here.Neighbors[Previous[corner]];
  } while (triangle != start && triangle != None);
  return false;
}

// Finds the edges that cross the line from a to b. Returns false if one is constrained, or if a point lies
// on the line.
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

// Flips an edge that crosses the line from a to b. Returns whether it still crosses. An edge that cannot be
// flipped yet has to wait; there always is one that can.
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
