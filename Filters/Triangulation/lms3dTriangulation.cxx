// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dTriangulation.h"

#include "Triangulation/lms3dEdgeInsertion.h"

#include <algorithm>
#include <utility>

lms3dTriangulation::lms3dTriangulation(
  std::vector<lms3dPoint2> points, const Numbers& loops, const Numbers& loopEnds)
  : Delaunay(std::move(points))
  , Valid(this->InsertPoints(static_cast<std::int32_t>(
            this->Delaunay.GetTriangles().GetTriangle(0).Corners.front())) &&
      this->InsertLoops(loops, loopEnds) && this->MarkInside(loops, loopEnds))
{
}

bool lms3dTriangulation::InsertPoints(std::int32_t count)
{
  int near = 0;
  for (std::int32_t point = 0; point < count; ++point)
  {
    if (!this->Delaunay.Insert(point, near))
    {
      return false;
    }
    near = this->Delaunay.GetTriangles().GetTriangleAt(point);
  }
  return true;
}

// Visits the edges of all loops until a visit returns false.
template <typename Visitor>
bool lms3dTriangulation::ForEdges(
  const Numbers& loops, const Numbers& loopEnds, const Visitor& visit)
{
  std::int32_t first = 0;
  for (std::int32_t end : loopEnds)
  {
    for (std::int32_t i = first; i < end; ++i)
    {
      if (!visit(loops[i], loops[i + 1 < end ? i + 1 : first]))
      {
        return false;
      }
    }
    first = end;
  }
  return true;
}

bool lms3dTriangulation::InsertLoops(const Numbers& loops, const Numbers& loopEnds)
{
  lms3dEdgeInsertion insertion(this->Delaunay);
  return ForEdges(
    loops, loopEnds, [&](std::int32_t a, std::int32_t b) { return insertion.Insert(a, b); });
}

// Floods the triangles from the left sides of the loops. The loops are valid only if the flood
// reaches neither a right side nor the super-triangle.
bool lms3dTriangulation::MarkInside(const Numbers& loops, const Numbers& loopEnds)
{
  std::vector<int> stack;
  std::vector<int> onRightSides;
  stack.reserve(loops.size());
  onRightSides.reserve(loops.size());
  ForEdges(loops, loopEnds,
    [&](std::int32_t a, std::int32_t b)
    {
      int edge;
      const int triangle = this->Delaunay.FindTriangle(a, b, edge);
      this->Enter(triangle, stack);
      onRightSides.push_back(this->Delaunay.GetTriangles().GetTriangle(triangle).Neighbors[edge]);
      return true;
    });
  while (!stack.empty())
  {
    const int triangle = stack.back();
    stack.pop_back();
    if (this->IsAtSuperTriangle(triangle))
    {
      return false;
    }
    const lms3dLinkedTriangles::Triangle& here =
      this->Delaunay.GetTriangles().GetTriangle(triangle);
    for (int side = 0; side < 3; ++side)
    {
      if (!here.IsConstrained[side])
      {
        this->Enter(here.Neighbors[side], stack);
      }
    }
  }
  return std::none_of(onRightSides.begin(), onRightSides.end(),
    [this](int triangle) { return this->IsInside(triangle); });
}

void lms3dTriangulation::Enter(int triangle, std::vector<int>& stack)
{
  if (!this->IsInside(triangle))
  {
    this->Delaunay.GetTriangles().SetInside(triangle);
    stack.push_back(triangle);
  }
}

bool lms3dTriangulation::IsAtSuperTriangle(int triangle) const
{
  const std::array<std::int32_t, 3>& corners = this->GetCorners(triangle);
  return std::any_of(corners.begin(), corners.end(),
    [&](std::int32_t point) { return this->Delaunay.IsSuperTriangleCorner(point); });
}
