// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dPolygon.h"

#include <cmath>
#include <cstddef>

namespace
{
// Where it has more digits than a double, corners nearly in line are told apart more often.
using Real = long double;
using Point = std::array<Real, 2>;

// A larger share of the area covered twice, or left out, is a polygon that crosses itself.
constexpr Real AreaTolerance = 1e-9L;

Real GetTwiceArea(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

std::array<Real, 3> GetNewellNormal(const std::vector<std::array<double, 3>>& corners)
{
  std::array<Real, 3> normal = { 0, 0, 0 };
  const std::array<double, 3>& first = corners.front();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::array<double, 3>& p = corners[i];
    const std::array<double, 3>& q = corners[(i + 1) % corners.size()];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int next = (axis + 1) % 3;
      const int last = (axis + 2) % 3;
      normal[axis] += (Real(p[next]) - first[next]) * (Real(q[last]) - first[last]) -
        (Real(p[last]) - first[last]) * (Real(q[next]) - first[next]);
    }
  }
  return normal;
}

/// The polygon seen along the axis that its normal is nearest to, counter-clockwise.
class FlatPolygon
{
public:
  explicit FlatPolygon(const std::vector<std::array<double, 3>>& corners)
  {
    const std::array<Real, 3> normal = GetNewellNormal(corners);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
    }
    const int first = normal[axis] > 0 ? (axis + 1) % 3 : (axis + 2) % 3;
    const int second = normal[axis] > 0 ? (axis + 2) % 3 : (axis + 1) % 3;
    this->TwiceArea = std::abs(normal[axis]);
    for (const std::array<double, 3>& corner : corners)
    {
      this->Points.push_back(
        { Real(corner[first]) - corners[0][first], Real(corner[second]) - corners[0][second] });
      this->Rest.push_back(static_cast<int>(this->Rest.size()));
    }
    this->DropRepeated();
  }

  Real GetTwiceArea() const { return this->TwiceArea; }

  /// Clips one ear, or a corner without area; false where there is none.
  bool Clip(std::vector<std::array<int, 3>>& triangles)
  {
    for (std::size_t i = 0; i < this->Rest.size(); ++i)
    {
      const int a = this->At(i, -1);
      const int b = this->At(i, 0);
      const int c = this->At(i, 1);
      const Real area = ::GetTwiceArea(this->Points[a], this->Points[b], this->Points[c]);
      if (area == 0 || (area > 0 && this->IsEmpty(a, b, c)))
      {
        if (area > 0)
        {
          triangles.push_back({ a, b, c });
        }
        this->ClippedArea += area;
        this->Rest.erase(this->Rest.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    }
    return false;
  }

  bool IsDone() const { return this->Rest.size() < 3; }

  bool IsCoveredOnce() const
  {
    return std::abs(this->ClippedArea - this->TwiceArea) <= AreaTolerance * this->TwiceArea;
  }

private:
  int At(std::size_t i, int offset) const
  {
    const std::size_t count = this->Rest.size();
    return this->Rest[(i + count + static_cast<std::size_t>(offset)) % count];
  }

  void DropRepeated()
  {
    for (std::size_t i = 0; i < this->Rest.size() && this->Rest.size() > 1;)
    {
      if (this->Points[this->At(i, 0)] == this->Points[this->At(i, 1)])
      {
        this->Rest.erase(this->Rest.begin() + static_cast<std::ptrdiff_t>(i));
      }
      else
      {
        ++i;
      }
    }
  }

  // Corners at the same place as the ear's are the two ends of a bridge to a hole.
  bool IsEmpty(int a, int b, int c) const
  {
    const Point& p = this->Points[a];
    const Point& q = this->Points[b];
    const Point& r = this->Points[c];
    for (int other : this->Rest)
    {
      const Point& x = this->Points[other];
      const bool isCorner = x == p || x == q || x == r;
      if (!isCorner && ::GetTwiceArea(p, q, x) >= 0 && ::GetTwiceArea(q, r, x) >= 0 &&
        ::GetTwiceArea(r, p, x) >= 0)
      {
        return false;
      }
    }
    return true;
  }

  std::vector<Point> Points;
  std::vector<int> Rest;
  Real TwiceArea;
  Real ClippedArea = 0;
};
} // namespace

lms3dPolygonTriangles lms3dCutPolygon(const std::vector<std::array<double, 3>>& corners)
{
  FlatPolygon polygon(corners);
  lms3dPolygonTriangles result = { true, {} };
  if (polygon.GetTwiceArea() == 0)
  {
    return result;
  }
  while (!polygon.IsDone() && polygon.Clip(result.Triangles))
  {
  }
  result.IsSimple = polygon.IsDone() && polygon.IsCoveredOnce();
  if (!result.IsSimple)
  {
    result.Triangles.clear();
  }
  return result;
}
