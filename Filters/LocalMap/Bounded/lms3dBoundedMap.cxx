// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedMap.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
// The radius of a facet, as a share of the angle to the nearest neighbour, and the largest such
// angle, radians.
constexpr double FacetShare = 0.25;
constexpr double MaximumAngle = 0.2;
// The largest share of its length that a vector along the axis has beside it.
constexpr double AxisTolerance = 1e-12;
// Radians by which a beam may pass outside of a triangle that it hits.
constexpr double BeamMargin = 1e-6;

// To the point of a neighbour's ray at the same range, as the sensor sees it.
double GetAngleToNeighborOnRays(
  const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range)
{
  const lms3dVector point = sphere.GetPointOnRay(index, range);
  double nearest = MaximumAngle * lms3dGetLength(point);
  for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
  {
    if (sphere.HasNeighbor(index, side) &&
      !(sphere.IsPoleRow(sphere.GetRow(index)) && side % 2 == 1))
    {
      const lms3dVector other = sphere.GetPointOnRay(sphere.GetNeighbor(index, side), range);
      nearest = std::min(nearest, lms3dGetLength(lms3dSubtract(other, point)));
    }
  }
  return nearest / lms3dGetLength(point);
}

// If beams are regular.
double GetAngleToNeighbor(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index)
{
  const int row = sphere.GetRow(index);
  const lms3dVector direction = sphere.GetDirection(index);
  double smallest = MaximumAngle;
  for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
  {
    if (!sphere.HasNeighbor(index, side) || (sphere.IsPoleRow(row) && side % 2 == 1))
    {
      continue;
    }
    const lms3dVector across =
      lms3dCross(direction, sphere.GetDirection(sphere.GetNeighbor(index, side)));
    smallest = std::min(smallest, lms3dGetLength(across));
  }
  return smallest;
}
} // namespace

void lms3dBoundedMap::AddFacet(
  const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range)
{
  if (!sphere.IsRegular())
  {
    this->AddFacet(lms3dScale(sphere.GetDirection(index), range),
      GetAngleToNeighborOnRays(sphere, index, sphere.GetRangeOnBeam(index)));
    return;
  }
  const std::array<double, 2>& horizontal = sphere.GetHorizontal(sphere.GetColumn(index));
  this->AddFacet(sphere.GetDirection(index), { horizontal[1], -horizontal[0], 0.0 }, range,
    GetAngleToNeighbor(sphere, index));
}

void lms3dBoundedMap::AddFacetOnBeam(
  const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range)
{
  if (sphere.IsRegular())
  {
    this->AddFacet(sphere, index, range);
    return;
  }
  this->AddFacet(
    sphere.GetPointOnRay(index, range), GetAngleToNeighborOnRays(sphere, index, range));
}

void lms3dBoundedMap::AddFacet(const lms3dVector& point, double angle)
{
  const double range = lms3dGetLength(point);
  const double level = std::hypot(point[0], point[1]);
  const lms3dVector right = level > AxisTolerance * range
    ? lms3dVector{ point[1] / level, -point[0] / level, 0.0 }
    : lms3dVector{ 0.0, -1.0, 0.0 };
  this->AddFacet(lms3dScale(point, 1.0 / range), right, range, angle);
}

void lms3dBoundedMap::AddFacet(
  const lms3dVector& direction, const lms3dVector& right, double range, double angle)
{
  // As the sensor sees them.
  const lms3dVector up = lms3dCross(right, direction);
  const double radius = range * FacetShare * angle;
  constexpr double Corners[3][2] = { { -0.8660254037844386, -0.5 }, { 0.8660254037844386, -0.5 },
    { 0.0, 1.0 } };
  const std::int32_t first = static_cast<std::int32_t>(this->Points.size());
  for (const double* corner : Corners)
  {
    const lms3dVector offset = lms3dAdd(lms3dScale(right, corner[0]), lms3dScale(up, corner[1]));
    this->Points.push_back(lms3dAdd(lms3dScale(direction, range), lms3dScale(offset, radius)));
  }
  this->Triangles.push_back({ first, first + 1, first + 2 });
  this->PatchIds.push_back(this->NumberOfPatches++);
}

bool lms3dBoundedMap::IsHit(
  const std::array<std::int32_t, 3>& triangle, const lms3dVector& point) const
{
  const double margin = BeamMargin * lms3dGetLength(point);
  const auto isInside = [&](std::int32_t p, std::int32_t q)
  {
    const lms3dVector edge = lms3dCross(this->Points[q], this->Points[p]);
    return lms3dDot(edge, point) >= -margin * lms3dGetLength(edge);
  };
  return isInside(triangle[0], triangle[1]) && isInside(triangle[1], triangle[2]) &&
    isInside(triangle[2], triangle[0]);
}

double lms3dBoundedMap::GetDeviation(const lms3dVector& point) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::array<std::int32_t, 3>& triangle : this->Triangles)
  {
    if (this->IsHit(triangle, point))
    {
      nearest = std::min(nearest,
        lms3dGetDistance(
          point, this->Points[triangle[0]], this->Points[triangle[1]], this->Points[triangle[2]]));
    }
  }
  return nearest;
}

lms3dBoundedMap lms3dBoundedMap::GetPart(const lms3dVector& direction) const
{
  lms3dBoundedMap part;
  for (const std::array<std::int32_t, 3>& triangle : this->Triangles)
  {
    if (this->IsHit(triangle, direction))
    {
      const auto first = static_cast<std::int32_t>(part.Points.size());
      for (std::int32_t corner : triangle)
      {
        part.Points.push_back(this->Points[corner]);
      }
      part.Triangles.push_back({ first, first + 1, first + 2 });
    }
  }
  return part;
}

bool lms3dBoundedMap::IsFacing(const std::array<std::int32_t, 3>& triangle) const
{
  return lms3dDot(lms3dCross(this->Points[triangle[0]], this->Points[triangle[1]]),
           this->Points[triangle[2]]) < 0.0;
}

void lms3dBoundedMap::RemoveUnusedPoints()
{
  std::vector<std::int32_t> numbers(this->Points.size(), -1);
  std::vector<lms3dVector> used;
  for (std::array<std::int32_t, 3>& triangle : this->Triangles)
  {
    for (std::int32_t& corner : triangle)
    {
      if (numbers[corner] < 0)
      {
        numbers[corner] = static_cast<std::int32_t>(used.size());
        used.push_back(this->Points[corner]);
      }
      corner = numbers[corner];
    }
  }
  this->Points = std::move(used);
}

void lms3dBoundedMap::RemoveUnusedPatches()
{
  std::vector<std::int32_t> numbers(this->NumberOfPatches, NoPatch);
  for (std::int32_t patch : this->PatchIds)
  {
    if (patch != NoPatch)
    {
      numbers[patch] = 0;
    }
  }
  this->NumberOfPatches = 0;
  for (std::int32_t& number : numbers)
  {
    number = number == NoPatch ? NoPatch : this->NumberOfPatches++;
  }
  for (std::int32_t& patch : this->PatchIds)
  {
    patch = patch == NoPatch ? NoPatch : numbers[patch];
  }
}
