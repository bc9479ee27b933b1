// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactReference.h"

#include "ExactTriangle.h"

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

Vector Subtract(const Vector& p, const Vector& q)
{
  return { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
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
    { node.Radius = std::max(node.Radius, GetLength(Subtract(p, node.Center))); });
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
    const Vector center = Subtract(node.Center, origin);
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
  const ExactTriangle exact(
    this->GetCorner(triangle, 0), this->GetCorner(triangle, 1), this->GetCorner(triangle, 2));
  static const Hit miss = { Quad(Infinity), Infinity, NoTriangle };
  if (exact.IsOutOfReach(origin, direction, limit) || !exact.IsInside(origin, direction))
  {
    return miss;
  }
  const Quad range = exact.GetRange(origin, direction);
  return range > 0 && range < limit ? Hit{ range, static_cast<double>(range), triangle } : miss;
}

double ExactReference::GetError(double range, const Hit& truth)
{
  const double unit = std::nextafter(truth.Range, Infinity) - truth.Range;
  const Quad error = range - truth.WideRange;
  return static_cast<double>((error < 0 ? -error : error) / unit);
}
