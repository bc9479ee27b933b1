// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace
{
constexpr std::size_t LeafSize = 4;

// Boxes are larger than their triangles by this share, more than any margin of a beam.
constexpr double BoxMargin = 1e-7;

double GetSquaredDistanceFromBox(const Vector& point, const Vector& low, const Vector& high)
{
  double squared = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double outside = std::max({ low[i] - point[i], point[i] - high[i], 0.0 });
    squared += outside * outside;
  }
  return squared;
}

bool MeetsBox(const Vector& inverse, const Vector& low, const Vector& high)
{
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const double a = low[i] * inverse[i];
    const double b = high[i] * inverse[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}
} // namespace

double GetDistance(const Vector& point, const Vector& a, const Vector& b)
{
  const Vector along = lms3dSubtract(b, a);
  const Vector to = lms3dSubtract(point, a);
  const double squared = Dot(along, along);
  const double share = squared > 0.0 ? std::clamp(Dot(along, to) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(to[0] - share * along[0], to[1] - share * along[1], to[2] - share * along[2]);
}

double GetDistance(const Vector& point, const std::array<Vector, 3>& triangle)
{
  const auto& [a, b, c] = triangle;
  const Vector normal = Cross(lms3dSubtract(b, a), lms3dSubtract(c, a));
  const auto isInside = [&](const Vector& p, const Vector& q)
  { return Dot(Cross(normal, lms3dSubtract(q, p)), lms3dSubtract(point, p)) >= 0.0; };
  const double length = std::sqrt(Dot(normal, normal));
  if (length > 0.0 && isInside(a, b) && isInside(b, c) && isInside(c, a))
  {
    return std::abs(Dot(normal, lms3dSubtract(point, a))) / length;
  }
  return std::min({ GetDistance(point, a, b), GetDistance(point, b, c), GetDistance(point, c, a) });
}

TriangleTree::TriangleTree(std::vector<Vector> points, std::vector<Triangle> triangles)
  : Points(std::move(points))
  , Triangles(std::move(triangles))
  , Order(this->Triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const auto [a, b, c] = this->GetCorners(i);
    this->Centers.push_back({ a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2] });
  }
  if (!this->Order.empty())
  {
    this->Build();
  }
}

std::array<Vector, 3> TriangleTree::GetCorners(std::size_t triangle) const
{
  const Triangle& corners = this->Triangles[triangle];
  return { this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]] };
}

void TriangleTree::Enclose(Node& node, std::size_t first, std::size_t count) const
{
  node.Low.fill(std::numeric_limits<double>::infinity());
  node.High.fill(-std::numeric_limits<double>::infinity());
  double size = 0.0;
  for (std::size_t i = first; i < first + count; ++i)
  {
    for (const Vector& corner : this->GetCorners(this->Order[i]))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        node.Low[axis] = std::min(node.Low[axis], corner[axis]);
        node.High[axis] = std::max(node.High[axis], corner[axis]);
        size = std::max(size, std::abs(corner[axis]));
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Low[axis] -= BoxMargin * size;
    node.High[axis] += BoxMargin * size;
  }
}

std::size_t TriangleTree::Halve(const Node& node, std::size_t count)
{
  const Vector size = lms3dSubtract(node.High, node.Low);
  const auto axis = std::max_element(size.begin(), size.end()) - size.begin();
  const auto begin = this->Order.begin() + static_cast<std::ptrdiff_t>(node.First);
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
    [&](std::size_t a, std::size_t b) { return this->Centers[a][axis] < this->Centers[b][axis]; });
  return count / 2;
}

void TriangleTree::Build()
{
  struct Part
  {
    std::size_t First;
    std::size_t Count;
    /// The node whose other child it is.
    std::size_t Parent;
  };
  constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  std::vector<Part> open = { { 0, this->Order.size(), None } };
  while (!open.empty())
  {
    const Part part = open.back();
    open.pop_back();
    const std::size_t place = this->Nodes.size();
    if (part.Parent != None)
    {
      this->Nodes[part.Parent].Other = place;
    }
    Node node;
    this->Enclose(node, part.First, part.Count);
    node.First = part.First;
    if (part.Count <= LeafSize)
    {
      node.Count = part.Count;
    }
    else
    {
      const std::size_t half = this->Halve(node, part.Count);
      open.push_back({ part.First + half, part.Count - half, place });
      open.push_back({ part.First, half, None });
    }
    this->Nodes.push_back(node);
  }
}

double TriangleTree::GetDistance(const Vector& point, double limit) const
{
  double nearest = limit;
  std::array<std::size_t, 128> open;
  std::size_t depth = 0;
  if (!this->Nodes.empty())
  {
    open[depth++] = 0;
  }
  const auto getSquare = [&](std::size_t place)
  { return GetSquaredDistanceFromBox(point, this->Nodes[place].Low, this->Nodes[place].High); };
  while (depth > 0)
  {
    const std::size_t place = open[--depth];
    const Node& node = this->Nodes[place];
    if (getSquare(place) >= nearest * nearest)
    {
      continue;
    }
    for (std::size_t i = node.First; i < node.First + node.Count; ++i)
    {
      nearest = std::min(nearest, ::GetDistance(point, this->GetCorners(this->Order[i])));
    }
    if (node.Count == 0)
    {
      const bool firstIsNearer = getSquare(place + 1) < getSquare(node.Other);
      open[depth++] = firstIsNearer ? node.Other : place + 1;
      open[depth++] = firstIsNearer ? place + 1 : node.Other;
    }
  }
  return nearest;
}

void TriangleTree::CastAt(
  std::size_t triangle, const Vector& direction, double margin, std::vector<Hit>& hits) const
{
  const auto [a, b, c] = this->GetCorners(triangle);
  const double volume = Dot(a, Cross(b, c));
  const double side = volume < 0.0 ? -1.0 : 1.0;
  // The sine of the angle between the beam and the plane through the sensor and an edge.
  const auto isInside = [&](const Vector& p, const Vector& q)
  {
    const Vector normal = Cross(p, q);
    return side * Dot(direction, normal) >= -margin * std::sqrt(Dot(normal, normal));
  };
  if (volume == 0.0 || !isInside(a, b) || !isInside(b, c) || !isInside(c, a))
  {
    return;
  }
  const double range = volume / Dot(Cross(lms3dSubtract(b, a), lms3dSubtract(c, a)), direction);
  if (range > 0.0 && std::isfinite(range))
  {
    hits.push_back({ range, triangle });
  }
}

void TriangleTree::Cast(const Vector& direction, double margin, std::vector<Hit>& hits) const
{
  constexpr double AlmostInfinite = 1e300;
  Vector inverse;
  for (int i = 0; i < 3; ++i)
  {
    inverse[i] = direction[i] != 0.0 ? 1.0 / direction[i] : AlmostInfinite;
  }
  hits.clear();
  std::array<std::size_t, 128> open;
  std::size_t depth = 0;
  if (!this->Nodes.empty())
  {
    open[depth++] = 0;
  }
  while (depth > 0)
  {
    const std::size_t place = open[--depth];
    const Node& node = this->Nodes[place];
    if (!MeetsBox(inverse, node.Low, node.High))
    {
      continue;
    }
    for (std::size_t i = node.First; i < node.First + node.Count; ++i)
    {
      this->CastAt(this->Order[i], direction, margin, hits);
    }
    if (node.Count == 0)
    {
      open[depth++] = node.Other;
      open[depth++] = place + 1;
    }
  }
}
