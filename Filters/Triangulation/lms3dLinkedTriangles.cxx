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

// Has a triangle, if there is one, name another neighbour in place of one.
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
      { old.Neighbors[edge], parts[Next[edge]], parts[Last[edge]] },
      { old.IsFixed[edge], false, false }, old.IsInside };
    this->Relink(old.Neighbors[edge], triangle, parts[edge]);
    this->TriangleAt[old.Corners[edge]] = parts[edge];
  }
  this->TriangleAt[point] = triangle;
  return parts;
}

// Of the three parts of a triangle, the one along the edge has no area until it is flipped.
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
  const std::int32_t r = a.Corners[Last[edge]];
  const std::int32_t s = b.Corners[Last[otherEdge]];
  const int qr = a.Neighbors[Next[edge]];
  const int ps = b.Neighbors[Next[otherEdge]];
  this->Triangles[triangle] = { { r, p, s }, { a.Neighbors[Last[edge]], ps, other },
    { a.IsFixed[Last[edge]], b.IsFixed[Next[otherEdge]], false }, a.IsInside };
  this->Triangles[other] = { { s, q, r }, { b.Neighbors[Last[otherEdge]], qr, triangle },
    { b.IsFixed[Last[otherEdge]], a.IsFixed[Next[edge]], false }, b.IsInside };
  this->Relink(ps, other, triangle);
  this->Relink(qr, triangle, other);
  this->TriangleAt[p] = triangle;
  this->TriangleAt[q] = other;
  this->TriangleAt[r] = triangle;
  this->TriangleAt[s] = other;
}

void lms3dLinkedTriangles::Fix(int triangle, int edge)
{
  const int other = this->Triangles[triangle].Neighbors[edge];
  this->Triangles[triangle].IsFixed[edge] = true;
  this->Triangles[other].IsFixed[this->FindEdge(other, triangle)] = true;
}
