// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include "Geometry/lms3dAngle.h"
#include "LocalMap/Bounded/lms3dSortedSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Radians. Larger than the rounding of rays.
constexpr double FanTolerance = 1e-6;

// Radians: larger than rounding and margins. Looking at one column more does no harm.
constexpr double AzimuthTolerance = 1e-6;

// The angle from one azimuth to another, -pi to pi.
double GetAngleBetween(double from, double to)
{
  const double angle = to - from;
  return angle > lms3dPi ? angle - 2.0 * lms3dPi
                         : (angle <= -lms3dPi ? angle + 2.0 * lms3dPi : angle);
}
} // namespace

lms3dTriangleCorner::lms3dTriangleCorner(const lms3dVector& position)
  : Position(position)
  , Azimuth(std::atan2(-position[1], position[0]))
  , IsPole(position[0] == 0.0 && position[1] == 0.0)
{
}

lms3dTriangleRasterizer::lms3dTriangleRasterizer(const lms3dBeamSphere& sphere,
  const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c,
  double margin)
  : Sphere(sphere)
  , Edges(MakeEdges(a.Position, b.Position, c.Position))
  , Corners{ a.Position, b.Position, c.Position }
  , Margin(margin)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Margins[i] = margin > 0.0 ? margin * lms3dGetLength(this->Edges[i]) : 0.0;
    this->Slopes[i] = -1.0 / this->Edges[i][2];
  }
  // The sum of the edges' normals is the normal of the triangle.
  const lms3dVector normal = lms3dAdd(lms3dAdd(this->Edges[0], this->Edges[1]), this->Edges[2]);
  this->Normal = normal;
  const double offset = lms3dDot(normal, a.Position);
  this->Plane = { { normal[0] / offset, normal[1] / offset, normal[2] / offset } };
  this->FindColumns(a, b, c);
}

lms3dTriangleRasterizer::Edges3 lms3dTriangleRasterizer::MakeEdges(
  const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return { lms3dCross(b, a), lms3dCross(c, b), lms3dCross(a, c) };
}

// Returns false only if no ray of the column hits the triangle. If the platform stands still during
// a fan, the rays of a column start at one point and lie in the vertical half-plane through it.
bool lms3dTriangleRasterizer::MeetsFan(int column, FanView& view) const
{
  const lms3dBeamSphere::GridIndex middle =
    this->Sphere.GetIndex(column, this->Sphere.GetNumberOfRows() / 2);
  const auto& rays = this->Sphere.GetRays();
  if (rays.GetLargestTurn() > 0.0 || rays.IsVertical(middle))
  {
    return true;
  }
  const auto& [origin, direction] = rays[middle];
  const double length = std::hypot(direction[0], direction[1]);
  view.IsPlane = true;
  view.Level[0] = direction[0] / length;
  view.Level[1] = direction[1] / length;
  int left = 0;
  int right = 0;
  int behind = 0;
  for (int i = 0; i < 3; ++i)
  {
    const lms3dVector corner = lms3dSubtract(this->Corners[i], origin);
    const double side = view.Level[0] * corner[1] - view.Level[1] * corner[0];
    view.Along[i] = view.Level[0] * corner[0] + view.Level[1] * corner[1];
    view.Up[i] = corner[2];
    view.Tolerance[i] =
      (FanTolerance + this->Margin) * (lms3dGetLength(corner) + lms3dGetLength(origin));
    left += side > view.Tolerance[i] ? 1 : 0;
    right += side < -view.Tolerance[i] ? 1 : 0;
    behind += view.Along[i] < -view.Tolerance[i] ? 1 : 0;
  }
  return left < 3 && right < 3 && behind < 3;
}

bool lms3dTriangleRasterizer::IsHitByRay(lms3dBeamSphere::GridIndex index) const
{
  const lms3dMapRay& ray = this->Sphere.GetRays()[index];
  const bool isFromOrigin = ray.Origin == lms3dVector{ 0.0, 0.0, 0.0 };
  const Edges3 edges = isFromOrigin
    ? this->Edges
    : MakeEdges(lms3dSubtract(this->Corners[0], ray.Origin),
        lms3dSubtract(this->Corners[1], ray.Origin), lms3dSubtract(this->Corners[2], ray.Origin));
  return std::all_of(edges.begin(), edges.end(),
           [&](const lms3dVector& edge)
           {
             const double side = lms3dDot(edge, ray.Direction);
             return side >= 0.0 ||
               (this->Margin > 0.0 && side >= -this->Margin * lms3dGetLength(edge));
           }) &&
    this->GetRangeOnRay(index) > 0.0;
}

double lms3dTriangleRasterizer::GetRangeOnRay(lms3dBeamSphere::GridIndex index) const
{
  const lms3dMapRay& ray = this->Sphere.GetRays()[index];
  return lms3dDot(this->Normal, lms3dSubtract(this->Corners[0], ray.Origin)) /
    lms3dDot(this->Normal, ray.Direction);
}

// The distance of an edge from the axis.
double lms3dTriangleRasterizer::GetDistanceFromAxis(const lms3dVector& a, const lms3dVector& b)
{
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  const double square = x * x + y * y;
  const double share = square > 0.0 ? std::clamp(-(a[0] * x + a[1] * y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a[0] + share * x, a[1] + share * y);
}

// The largest angle about the axis between a point of the triangle and the column of the beam that
// hits it.
double lms3dTriangleRasterizer::GetParallax(
  const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c) const
{
  if (this->Sphere.IsRegular())
  {
    return 0.0;
  }
  const double offset = this->Sphere.GetRays().GetLargestOffset();
  const double nearest = std::min({ GetDistanceFromAxis(a.Position, b.Position),
    GetDistanceFromAxis(b.Position, c.Position), GetDistanceFromAxis(c.Position, a.Position) });
  return this->Sphere.GetRays().GetLargestTurn() +
    (offset < nearest  ? std::asin(offset / nearest)
        : offset > 0.0 ? lms3dPi
                       : 0.0);
}

void lms3dTriangleRasterizer::FindColumns(
  const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c)
{
  const std::vector<double>& azimuths = this->Sphere.GetAzimuths();
  const int columns = this->Sphere.GetNumberOfColumns();
  this->FirstColumn = 0;
  this->NumberOfColumns = columns;
  const double ab = GetAngleBetween(a.Azimuth, b.Azimuth);
  const double bc = GetAngleBetween(b.Azimuth, c.Azimuth);
  const double ca = GetAngleBetween(c.Azimuth, a.Azimuth);
  const double longest = std::max({ std::abs(ab), std::abs(bc), std::abs(ca) });
  const double tolerance = AzimuthTolerance + this->GetParallax(a, b, c);
  // The triangle may contain a pole: all columns.
  if (a.IsPole || b.IsPole || c.IsPole || std::abs(ab + bc + ca) > lms3dPi ||
    longest > lms3dPi - AzimuthTolerance)
  {
    return;
  }
  const double width = std::max({ 0.0, ab, ab + bc }) - std::min({ 0.0, ab, ab + bc });
  if (width + 2.0 * tolerance >= 2.0 * lms3dPi)
  {
    return;
  }
  double low = a.Azimuth + std::min({ 0.0, ab, ab + bc }) - tolerance;
  low -= 2.0 * lms3dPi * std::floor((low - azimuths.front()) / (2.0 * lms3dPi));
  const double high = low + width + 2.0 * tolerance;
  // Where the columns would be if they were evenly spaced.
  const double density = columns / (2.0 * lms3dPi);
  const auto findEnd = [&](double angle, const auto& isBefore)
  {
    const double near = std::max(0.0, (angle - azimuths.front()) * density);
    return lms3dFindEndOf(azimuths, static_cast<int>(std::min<double>(near, columns)), isBefore);
  };
  const int first = findEnd(low, [low](double azimuth) { return azimuth < low; });
  const int last = findEnd(high, [high](double azimuth) { return azimuth <= high; });
  const double wrappedHigh = high - 2.0 * lms3dPi;
  const int wrapped = wrappedHigh < azimuths.front()
    ? 0
    : findEnd(wrappedHigh, [wrappedHigh](double azimuth) { return azimuth <= wrappedHigh; });
  this->FirstColumn = first == columns ? 0 : first;
  this->NumberOfColumns = last - first + std::min(wrapped, first);
}

bool lms3dTriangleRasterizer::FindRows(int column, NearRows& rows) const
{
  const std::array<double, 2>& level = this->Sphere.GetHorizontal(column);
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const lms3dVector& edge = this->Edges[i];
    const double side = edge[0] * level[0] + edge[1] * level[1] + this->Margins[i];
    if (edge[2] > 0.0)
    {
      low = std::max(low, side * this->Slopes[i]);
    }
    else if (edge[2] < 0.0)
    {
      high = std::min(high, side * this->Slopes[i]);
    }
    else if (side < 0.0)
    {
      return false;
    }
  }
  if (low > high)
  {
    return false;
  }
  const std::vector<double>& tangents = this->Sphere.GetTangents();
  const bool isFirst = rows.First == NoRow;
  const int nearFirst = isFirst ? this->Sphere.GetRowNear(low) : rows.First + rows.FirstStep;
  const int nearEnd = isFirst ? this->Sphere.GetRowNear(high) : rows.Last + 1 + rows.LastStep;
  const int first =
    lms3dFindEndOf(tangents, nearFirst, [low](double tangent) { return tangent < low; });
  const int last =
    lms3dFindEndOf(tangents, nearEnd, [high](double tangent) { return tangent <= high; }) - 1;
  rows = { first, last, isFirst ? 0 : first - rows.First, isFirst ? 0 : last - rows.Last };
  return first <= last;
}
