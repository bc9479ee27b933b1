// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPatchTriangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// The smallest cosine between a direction and the normal of the projection plane.
constexpr double MinimumCosine = 1e-6;
constexpr int SuperTriangleCorners = 3;
} // namespace

lms3dPatchTriangulation::lms3dPatchTriangulation(
  const lms3dPatchOutlines& outlines, int patch, const lms3dVector& axis)
  : Outlines(outlines)
  , Numbers(outlines.GetOutline(patch).Vertices)
{
  std::sort(this->Numbers.begin(), this->Numbers.end());
  this->Numbers.erase(std::unique(this->Numbers.begin(), this->Numbers.end()), this->Numbers.end());
  this->Vertices.reserve(this->Numbers.size() + SuperTriangleCorners);
  this->Corners.reserve(this->Numbers.size() + SuperTriangleCorners);
  lms3dVector ahead = { 0.0, 0.0, 0.0 };
  for (std::int32_t number : this->Numbers)
  {
    this->Append(this->Outlines.GetVertices()[number]);
    ahead = lms3dAdd(ahead, this->Vertices.back().Direction);
  }
  this->Valid =
    this->Numbers.size() >= 3 && (this->Project(patch, axis) || this->Project(patch, ahead));
  for (int i = 0; this->Valid && i < SuperTriangleCorners; ++i)
  {
    this->Append({ this->Axes[2], 1.0 }); // Never used.
  }
}

bool lms3dPatchTriangulation::Project(int patch, const lms3dVector& axis)
{
  this->Axes[2] = lms3dScale(axis, 1.0 / lms3dGetLength(axis));
  const lms3dVector& ahead = this->Axes[2];
  const lms3dVector other =
    std::abs(ahead[2]) < 0.7 ? lms3dVector{ 0.0, 0.0, 1.0 } : lms3dVector{ 1.0, 0.0, 0.0 };
  const lms3dVector right = lms3dCross(ahead, other);
  this->Axes[0] = lms3dScale(right, 1.0 / lms3dGetLength(right));
  this->Axes[1] = lms3dCross(this->Axes[0], ahead);
  std::vector<lms3dPoint2> points;
  points.reserve(this->Numbers.size() + SuperTriangleCorners);
  for (const lms3dMapVertex& vertex : this->Vertices)
  {
    if (!(lms3dDot(ahead, vertex.Direction) > MinimumCosine))
    {
      return false;
    }
    points.push_back(this->GetPoint(vertex.Direction));
  }
  const lms3dPatchOutlines::Outline& outline = this->Outlines.GetOutline(patch);
  std::vector<std::int32_t> loops;
  loops.reserve(outline.Vertices.size());
  for (std::int32_t number : outline.Vertices)
  {
    loops.push_back(static_cast<std::int32_t>(
      std::lower_bound(this->Numbers.begin(), this->Numbers.end(), number) -
      this->Numbers.begin()));
  }
  this->Triangulation =
    std::make_unique<lms3dTriangulation>(std::move(points), loops, outline.LoopEnds);
  return this->Triangulation->IsValid();
}

lms3dPoint2 lms3dPatchTriangulation::GetPoint(const lms3dVector& direction) const
{
  const double ahead = lms3dDot(this->Axes[2], direction);
  return { lms3dDot(this->Axes[0], direction) / ahead, lms3dDot(this->Axes[1], direction) / ahead };
}

void lms3dPatchTriangulation::Append(const lms3dMapVertex& vertex)
{
  this->Vertices.push_back(vertex);
  this->Corners.emplace_back(lms3dScale(vertex.Direction, 1.0 / vertex.InverseRange));
}

bool lms3dPatchTriangulation::Insert(const lms3dMapVertex& vertex, int near)
{
  if (!(lms3dDot(this->Axes[2], vertex.Direction) > MinimumCosine) ||
    this->Triangulation->Insert(this->GetPoint(vertex.Direction), near) == lms3dTriangulation::None)
  {
    return false;
  }
  this->Append(vertex);
  return true;
}

lms3dMapVertex lms3dPatchTriangulation::MakeVertex(
  const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex beam, double range)
{
  if (sphere.IsRegular())
  {
    return { sphere.GetDirection(beam), 1.0 / range };
  }
  const lms3dVector point = sphere.GetPointOnRay(beam, range);
  const double inverse = 1.0 / lms3dGetLength(point);
  return { lms3dScale(point, inverse), inverse };
}

std::vector<lms3dMapVertex> lms3dPatchTriangulation::GetAddedVertices() const
{
  const auto first = static_cast<std::ptrdiff_t>(this->Numbers.size()) + SuperTriangleCorners;
  return { this->Vertices.begin() + first, this->Vertices.end() };
}

std::vector<std::array<std::int32_t, 3>> lms3dPatchTriangulation::GetTriangles() const
{
  const auto shared = static_cast<std::int32_t>(this->Numbers.size());
  const auto outlineVertices = static_cast<std::int32_t>(this->Outlines.GetVertices().size());
  std::vector<std::array<std::int32_t, 3>> triangles;
  triangles.reserve(this->GetNumberOfTriangles());
  for (int i = 0; i < this->GetNumberOfTriangles(); ++i)
  {
    if (this->IsInside(i))
    {
      std::array<std::int32_t, 3> corners = this->GetCorners(i);
      for (std::int32_t& corner : corners)
      {
        corner = corner < shared ? this->Numbers[corner]
                                 : outlineVertices + corner - shared - SuperTriangleCorners;
      }
      triangles.push_back(corners);
    }
  }
  return triangles;
}
