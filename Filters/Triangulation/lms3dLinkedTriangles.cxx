// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dLinkedTriangles.h"

lms3dLinkedTriangles::lms3dLinkedTriangles(std::int32_t points, std::size_t expected)
  : TriangleAt(points, None)
{
  this->Triangles.reserve(2 * expected);
  this->Triangles.push_back({ { points - 3, points - 2, points - 1 }, { None, None, None },
    { false, false, false }, false });
  for (std::int32_t point = points - 3; point < points; ++point)
  {
    this->TriangleAt[point] = 0;
  }
}

// Replaces a neighbour of a triangle, if there is a triangle.
void lms3dLinkedTriangles::Relink(int triangle, int from, int to)
{
  if (triangle != None)
  {
    this->Triangles[triangle].Neighbors[this->FindEdge(triangle, from)] = to;
  }
}

std::array<int, 3> lms3dLinkedTriangles::SplitTriangle(std::int32_t point, int triangle)
{
  const Triangle old = this->Triangles[triangle];
  const int count = this->GetNumberOfTriangles();
  const std::array<int, 3> parts = { triangle, count, count + 1 };
  this->Triangles.resize(this->Triangles.size() + 2);
  for (int edge = 0; edge < 3; ++edge)
  {
    this->Triangles[parts[edge]] = { { old.Corners[edge], old.Corners[Next[edge]], point },
      { old.Neighbors[edge], parts[Next[edge]], parts[Previous[edge]] },
      { old.IsConstrained[edge], false, false }, old.IsInside };
    this->Relink(old.Neighbors[edge], triangle, parts[edge]);
    this->TriangleAt[old.Corners[edge]] = parts[edge];
  }
  this->TriangleAt[point] = triangle;
  return parts;
}

// The part of the first triangle along the edge has no area until the edge is flipped.
std::array<int, 4> lms3dLinkedTriangles::SplitEdge(std::int32_t point, int triangle, int edge)
{
  const int other = this->Triangles[triangle].Neighbors[edge];
  const std::array<int, 3> parts = this->SplitTriangle(point, triangle);
  this->Flip(parts[edge], 0);
  return { parts[0], parts[1], parts[2], other };
}

void lms3dLinkedTriangles::Flip(int triangle, int edge)
{
  const int other = this->Triangles[triangle].Neighbors[edge];
  const int otherEdge = this->FindEdge(other, triangle);
  const Triangle a = this->Triangles[triangle];
  const Triangle b = this->Triangles[other];
  // The edge runs from p to q in the triangle; r is opposite in it, s in the other.
  const std::int32_t p = a.Corners[edge];
  const std::int32_t q = a.Corners[Next[edge]];
  const std::int32_t r = a.Corners[Previous[edge]];
  const std::int32_t s = b.Corners[Previous[otherEdge]];
  const int qr = a.Neighbors[Next[edge]];
  const int ps = b.Neighbors[Next[otherEdge]];
  this->Triangles[triangle] = { { r, p, s }, { a.Neighbors[Previous[edge]], ps, other },
    { a.IsConstrained[Previous[edge]], b.IsConstrained[Next[otherEdge]], false }, a.IsInside };
  this->Triangles[other] = { { s, q, r }, { b.Neighbors[Previous[otherEdge]], qr, triangle },
    { b.IsConstrained[Previous[otherEdge]], a.IsConstrained[Next[edge]], false }, b.IsInside };
  this->Relink(ps, other, triangle);
  this->Relink(qr, triangle, other);
  this->TriangleAt[p] = triangle;
  this->TriangleAt[q] = other;
  this->TriangleAt[r] = triangle;
  this->TriangleAt[s] = other;
}

void lms3dLinkedTriangles::Constrain(int triangle, int edge)
{
  const int other = this->Triangles[triangle].Neighbors[edge];
  this->Triangles[triangle].IsConstrained[edge] = true;
  this->Triangles[other].IsConstrained[this->FindEdge(other, triangle)] = true;
}
