// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactReference.h"

#include "ExactExpansion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
using Quad = ExactReference::Quad;
using Vector = ExactReference::Vector;

constexpr double Infinity = std::numeric_limits<double>::infinity();

// A leaf of the tree has no more triangles than this.
constexpr std::size_t LeafSize = 4;

// Widens balls and ranges in the search, far beyond the rounding of a double.
constexpr double Margin = 1e-14;

template <typename Number>
using Triple = std::array<Number, 3>;

template <typename Number>
Triple<Number> Subtract(const Vector& p, const Vector& q)
{
  return { Number(p[0]) - Number(q[0]), Number(p[1]) - Number(q[1]), Number(p[2]) - Number(q[2]) };
}

template <typename Number>
Number GetDeterminant(const Triple<Number>& p, const Triple<Number>& q, const Triple<Number>& r)
{
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
    p[2] * (q[0] * r[1] - q[1] * r[0]);
}

template <typename Number>
Number GetMagnitude(const Number& x)
{
  return x < 0 ? -x : x;
}

// No determinant's terms sum to more than this.
template <typename Number>
Number GetSize(const Triple<Number>& p, const Triple<Number>& q, const Triple<Number>& r)
{
  Number size = 1;
  for (const Triple<Number>* t : { &p, &q, &r })
  {
    size = size * (GetMagnitude((*t)[0]) + GetMagnitude((*t)[1]) + GetMagnitude((*t)[2]));
  }
  return size;
}

// Two units in the last place of 1.
template <typename Number>
Number GetPrecision()
{
  Number unit = 1;
  while (Number(1) + unit / 2 != Number(1))
  {
    unit = unit / 2;
  }
  return 2 * unit;
}

/// Two points of a beam's path seen from where the determinant's origin is, and its direction.
struct Edge
{
  const Vector* Direction;
  const Vector* Origin;
  const Vector* P;
  const Vector* Q;
};

// A determinant rounds 10 times at most on the way to a term: below 5 such precisions of its size.
template <typename Number>
int GetCertainSign(const Edge& edge)
{
  static const Number bound = 8 * GetPrecision<Number>();
  const Vector& d = *edge.Direction;
  const Triple<Number> direction = { Number(d[0]), Number(d[1]), Number(d[2]) };
  const Triple<Number> p = Subtract<Number>(*edge.P, *edge.Origin);
  const Triple<Number> q = Subtract<Number>(*edge.Q, *edge.Origin);
  const Number value = GetDeterminant(direction, p, q);
  const Number error = bound * GetSize(direction, p, q);
  return (value > error) - (value < -error);
}

int GetExactSign(const Edge& edge)
{
  const Vector& d = *edge.Direction;
  const Triple<ExactExpansion> direction = { ExactExpansion(d[0]), ExactExpansion(d[1]),
    ExactExpansion(d[2]) };
  return GetDeterminant(direction, Subtract<ExactExpansion>(*edge.P, *edge.Origin),
    Subtract<ExactExpansion>(*edge.Q, *edge.Origin))
    .GetSign();
}

int GetSign(const Edge& edge)
{
  int sign = GetCertainSign<double>(edge);
  sign = sign != 0 ? sign : GetCertainSign<Quad>(edge);
  return sign != 0 ? sign : GetExactSign(edge);
}

bool IsInside(const Vector* const* corners, const Vector& origin, const Vector& direction)
{
  bool isLeft = false;
  bool isRight = false;
  for (int i = 0; i < 3 && !(isLeft && isRight); ++i)
  {
    const int sign = GetSign({ &direction, &origin, corners[(i + 1) % 3], corners[(i + 2) % 3] });
    isLeft = isLeft || sign > 0;
    isRight = isRight || sign < 0;
  }
  return isLeft != isRight;
}

/// The plane's offset and slope, whose quotient is the range.
template <typename Number>
std::pair<Number, Number> GetPlane(
  const Vector* const* corners, const Vector& origin, const Vector& d)
{
  const Triple<Number> p = Subtract<Number>(*corners[1], *corners[0]);
  const Triple<Number> q = Subtract<Number>(*corners[2], *corners[0]);
  return { GetDeterminant(Subtract<Number>(*corners[0], origin), p, q),
    GetDeterminant({ Number(d[0]), Number(d[1]), Number(d[2]) }, p, q) };
}

// Whether double precision proves that a plane is behind the origin, or beyond a limit.
bool IsOutOfReach(const Vector* const* corners, const Vector& origin, const Vector& d, double limit)
{
  static const double bound = 8 * GetPrecision<double>();
  const Triple<double> p = Subtract<double>(*corners[1], *corners[0]);
  const Triple<double> q = Subtract<double>(*corners[2], *corners[0]);
  const Triple<double> a = Subtract<double>(*corners[0], origin);
  const double offset = GetDeterminant(a, p, q);
  const double slope = GetDeterminant<double>(d, p, q);
  const double offsetError = bound * GetSize(a, p, q);
  const double slopeError = bound * GetSize<double>(d, p, q);
  if (std::abs(offset) <= offsetError || std::abs(slope) <= slopeError)
  {
    return false;
  }
  const double least = (std::abs(offset) - offsetError) / (std::abs(slope) + slopeError);
  return (offset < 0.0) != (slope < 0.0) || least > limit * (1.0 + Margin);
}

// Whether quadruple precision keeps 24 digits of a plane's offset and slope.
bool IsWide(const Quad& offset, const Quad& slope, const Vector* const* corners,
  const Vector& origin, const Vector& d)
{
  static const Quad share = 1e25 * GetPrecision<Quad>();
  const Triple<Quad> p = Subtract<Quad>(*corners[1], *corners[0]);
  const Triple<Quad> q = Subtract<Quad>(*corners[2], *corners[0]);
  const Triple<Quad> a = Subtract<Quad>(*corners[0], origin);
  return GetMagnitude(offset) > share * GetSize(a, p, q) &&
    GetMagnitude(slope) > share * GetSize<Quad>({ d[0], d[1], d[2] }, p, q);
}

// The beam is known to cross the plane, so the slope is not 0.
Quad GetRange(const Vector* const* corners, const Vector& origin, const Vector& direction)
{
  const auto [offset, slope] = GetPlane<Quad>(corners, origin, direction);
  if (IsWide(offset, slope, corners, origin, direction))
  {
    return offset / slope;
  }
  const auto [exactOffset, exactSlope] = GetPlane<ExactExpansion>(corners, origin, direction);
  return exactOffset.GetValue() / exactSlope.GetValue();
}

double GetDot(const Vector& p, const Vector& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

double GetLength(const Vector& p)
{
  return std::sqrt(GetDot(p, p));
}
} // namespace

ExactReference::ExactReference(std::vector<Vector> points, std::vector<Triangle> triangles)
  : Points(std::move(points))
  , Triangles(std::move(triangles))
  , Order(this->Triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->Nodes.reserve(this->Triangles.size() + 1);
  this->Build(0, this->Triangles.size());
}

const Vector& ExactReference::GetCorner(std::int32_t triangle, int corner) const
{
  return this->Points[this->Triangles[triangle][corner]];
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the logarithm of the number of triangles.
std::size_t ExactReference::Build(std::size_t first, std::size_t count)
{
  const std::size_t number = this->Nodes.size();
  this->Nodes.push_back({ {}, 0.0, first, count, 0 });
  this->Enclose(this->Nodes[number]);
  if (count > LeafSize)
  {
    this->Split(this->Nodes[number]);
    this->Build(first, count / 2);
    const std::size_t other = this->Build(first + count / 2, count - count / 2);
    this->Nodes[number].Other = other;
  }
  return number;
}

void ExactReference::Enclose(Node& node) const
{
  Vector low = { Infinity, Infinity, Infinity };
  Vector high = { -Infinity, -Infinity, -Infinity };
  const auto forEachCorner = [&](const auto& action)
  {
    for (std::size_t i = node.First; i < node.First + node.Count; ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        action(this->GetCorner(this->Order[i], corner));
      }
    }
  };
  forEachCorner(
    [&](const Vector& p)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    });
  node.Center = { 0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1],
    0.5 * low[2] + 0.5 * high[2] };
  forEachCorner([&](const Vector& p)
    { node.Radius = std::max(node.Radius, GetLength(Subtract<double>(p, node.Center))); });
}

// Orders the node's triangles about their middle, along the axis in which they are spread most.
void ExactReference::Split(const Node& node)
{
  const auto begin = this->Order.begin() + static_cast<std::ptrdiff_t>(node.First);
  const auto end = begin + static_cast<std::ptrdiff_t>(node.Count);
  const auto getPlace = [this](std::int32_t triangle, int axis)
  {
    return this->GetCorner(triangle, 0)[axis] + this->GetCorner(triangle, 1)[axis] +
      this->GetCorner(triangle, 2)[axis];
  };
  int widest = 0;
  double width = -1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [least, greatest] = std::minmax_element(begin, end,
      [&](std::int32_t a, std::int32_t b) { return getPlace(a, axis) < getPlace(b, axis); });
    const double spread = getPlace(*greatest, axis) - getPlace(*least, axis);
    widest = spread > width ? axis : widest;
    width = std::max(width, spread);
  }
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(node.Count / 2), end,
    [&](std::int32_t a, std::int32_t b) { return getPlace(a, widest) < getPlace(b, widest); });
}

ExactReference::Hit ExactReference::Cast(
  const Vector& origin, const Vector& direction, double limit) const
{
  const double length = GetLength(direction);
  Hit nearest = { Quad(limit), limit, NoTriangle };
  // A node's ball is passed where the beam's line stays away from it, or meets it only behind the
  // origin, or behind the nearest hit.
  const auto mayHit = [&](const Node& node)
  {
    const Vector center = Subtract<double>(node.Center, origin);
    const double radius = node.Radius + Margin * (node.Radius + GetLength(center));
    const double along = GetDot(center, direction) / length;
    const double x = center[1] * direction[2] - center[2] * direction[1];
    const double y = center[2] * direction[0] - center[0] * direction[2];
    const double z = center[0] * direction[1] - center[1] * direction[0];
    return std::sqrt(x * x + y * y + z * z) <= radius * length && along >= -radius &&
      along - radius <= nearest.Range * length * (1.0 + Margin);
  };
  std::vector<std::size_t> open = { 0 };
  while (!open.empty())
  {
    const Node& node = this->Nodes[open.back()];
    const std::size_t next = open.back() + 1;
    open.pop_back();
    if (node.Count == 0 || !mayHit(node))
    {
      continue;
    }
    if (node.Other != 0)
    {
      open.push_back(node.Other);
      open.push_back(next);
      continue;
    }
    for (std::size_t i = node.First; i < node.First + node.Count; ++i)
    {
      const double reach = nearest.Range * (1.0 + Margin);
      const Hit hit = this->Cast(this->Order[i], origin, direction, reach);
      if (hit.Triangle != NoTriangle &&
        (hit.WideRange < nearest.WideRange ||
          (hit.WideRange == nearest.WideRange && hit.Triangle < nearest.Triangle)))
      {
        nearest = hit;
      }
    }
  }
  return nearest;
}

ExactReference::Hit ExactReference::Cast(
  std::int32_t triangle, const Vector& origin, const Vector& direction, double limit) const
{
  const Vector* corners[3] = { &this->GetCorner(triangle, 0), &this->GetCorner(triangle, 1),
    &this->GetCorner(triangle, 2) };
  static const Hit miss = { Quad(Infinity), Infinity, NoTriangle };
  if (IsOutOfReach(corners, origin, direction, limit) || !IsInside(corners, origin, direction))
  {
    return miss;
  }
  const Quad range = GetRange(corners, origin, direction);
  return range > 0 && range < limit ? Hit{ range, static_cast<double>(range), triangle } : miss;
}

double ExactReference::GetError(double range, const Hit& truth)
{
  const double unit = std::nextafter(truth.Range, Infinity) - truth.Range;
  return static_cast<double>(GetMagnitude(range - truth.WideRange) / unit);
}
