// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCreaseSnapping.h"

#include "Fusion/lms3dRasterRows.h"

#include <array>
#include <cmath>
#include <optional>

namespace
{
// Cells: how far a corner may be from a crease, from the end of its part, and from a meeting point of creases.
constexpr double Reach = 8.0;
constexpr double ReachAlong = 8.0;
constexpr double ReachOfMeeting = 12.0;
// The sine of the smallest angle between lines that meet.
constexpr double SmallestSine = 0.1;

struct Foot
{
  double Distance;
  double Along;
};

Foot GetFoot(const lms3dPoint2& point, const lms3dCreaseLine& crease)
{
  const double du = point[0] - crease.Point[0];
  const double dv = point[1] - crease.Point[1];
  return { std::abs(crease.Direction[0] * dv - crease.Direction[1] * du),
    crease.Direction[0] * du + crease.Direction[1] * dv };
}

bool IsOn(const lms3dCreaseParts& parts, double along)
{
  for (const auto& [first, last] : parts)
  {
    if (along >= first - ReachAlong && along <= last + ReachAlong)
    {
      return true;
    }
  }
  return false;
}

lms3dPoint2 GetPoint(const lms3dCreaseLine& crease, double along)
{
  return { crease.Point[0] + along * crease.Direction[0],
    crease.Point[1] + along * crease.Direction[1] };
}

std::optional<lms3dPoint2> Intersect(const lms3dCreaseLine& a, const lms3dCreaseLine& b)
{
  const double sine = a.Direction[0] * b.Direction[1] - a.Direction[1] * b.Direction[0];
  if (std::abs(sine) < SmallestSine)
  {
    return {};
  }
  const double du = b.Point[0] - a.Point[0];
  const double dv = b.Point[1] - a.Point[1];
  return GetPoint(a, (du * b.Direction[1] - dv * b.Direction[0]) / sine);
}

std::optional<lms3dPoint2> FindPlace(
  const lms3dPoint2& point, const std::vector<lms3dCreaseLine>& creases)
{
  const lms3dCreaseLine* nearest = nullptr;
  const lms3dCreaseLine* second = nullptr;
  Foot foot = {};
  Foot other = {};
  for (const lms3dCreaseLine& crease : creases)
  {
    const Foot candidate = GetFoot(point, crease);
    if (candidate.Distance > Reach || !IsOn(crease.Parts, candidate.Along))
    {
      continue;
    }
    if (!nearest || candidate.Distance < foot.Distance)
    {
      second = nearest;
      other = foot;
      nearest = &crease;
      foot = candidate;
    }
    else if (!second || candidate.Distance < other.Distance)
    {
      second = &crease;
      other = candidate;
    }
  }
  if (!nearest)
  {
    return {};
  }
  if (second)
  {
    const std::optional<lms3dPoint2> meeting = Intersect(*nearest, *second);
    if (meeting && std::hypot((*meeting)[0] - point[0], (*meeting)[1] - point[1]) <= ReachOfMeeting)
    {
      return meeting;
    }
  }
  return GetPoint(*nearest, foot.Along);
}

// Samples the way at half cells.
bool IsWayFree(const lms3dPoint2& from, const lms3dPoint2& to, const lms3dRaster& region)
{
  const int steps =
    2 * static_cast<int>(std::ceil(std::hypot(to[0] - from[0], to[1] - from[1]))) + 1;
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    const auto u = static_cast<std::int32_t>(std::floor(from[0] + share * (to[0] - from[0])));
    const auto v = static_cast<std::int32_t>(std::floor(from[1] + share * (to[1] - from[1])));
    if (region.Has(&lms3dRasterBlock::Passed, u, v))
    {
      return false;
    }
  }
  return true;
}

struct Snapped
{
  lms3dPoint2 Point;
  bool IsFixed;
};

// Whether a side of an outline moves inwards, or no beam passed where it moves over.
bool IsSweepFree(const std::array<lms3dPoint2, 3>& triangle, const lms3dRaster& region)
{
  return lms3dGetOrientation(triangle[0], triangle[1], triangle[2]) >= 0 ||
    lms3dForTouchedRows(triangle,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      { return !region.HasAny(&lms3dRasterBlock::Passed, row, first, last); });
}

// Moves corners back until no side moves over a beam that passed.
void MoveBack(const lms3dLoop& loop, const lms3dRaster& region, std::vector<Snapped>& corners)
{
  const std::size_t count = loop.size();
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t next = (i + 1) % count;
      Snapped& a = corners[i];
      Snapped& b = corners[next];
      if (b.IsFixed && !IsSweepFree({ loop[i], loop[next], b.Point }, region))
      {
        b = { loop[next], false };
        isChanged = true;
      }
      if (a.IsFixed && !IsSweepFree({ loop[i], b.Point, a.Point }, region))
      {
        a = { loop[i], false };
        isChanged = true;
      }
    }
  }
}

bool IsSame(const lms3dPoint2& a, const lms3dPoint2& b)
{
  return std::abs(a[0] - b[0]) < 1e-7 && std::abs(a[1] - b[1]) < 1e-7;
}

// Whether the outline goes forth and back at a corner.
bool IsSpike(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c)
{
  const double cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
  const double dot = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
  return dot < 0.0 && std::abs(cross) <= 1e-6 * -dot;
}

// Removes copies and spikes until there are none.
void Clean(std::vector<Snapped>& corners)
{
  for (bool isChanged = true; isChanged && corners.size() >= 3;)
  {
    isChanged = false;
    std::vector<Snapped> kept;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const lms3dPoint2& next = corners[(i + 1) % corners.size()].Point;
      const lms3dPoint2& previous = kept.empty() ? corners.back().Point : kept.back().Point;
      if (IsSame(corners[i].Point, next) || IsSpike(previous, corners[i].Point, next))
      {
        isChanged = true;
        continue;
      }
      kept.push_back(corners[i]);
    }
    corners = kept;
  }
}
} // namespace

std::vector<lms3dLoop> lms3dSnapToCreases(const std::vector<lms3dLoop>& loops,
  const std::vector<lms3dCreaseLine>& creases, const lms3dRaster& region,
  std::vector<bool>& isFixed)
{
  std::vector<lms3dLoop> result;
  isFixed.clear();
  for (const lms3dLoop& loop : loops)
  {
    std::vector<Snapped> corners;
    for (const lms3dPoint2& point : loop)
    {
      const std::optional<lms3dPoint2> place = FindPlace(point, creases);
      const bool moves = place && IsWayFree(point, *place, region);
      corners.push_back({ moves ? *place : point, moves });
    }
    MoveBack(loop, region, corners);
    Clean(corners);
    if (corners.size() < 3)
    {
      continue;
    }
    lms3dLoop moved;
    for (const Snapped& corner : corners)
    {
      moved.push_back(corner.Point);
      isFixed.push_back(corner.IsFixed);
    }
    result.push_back(moved);
  }
  return result;
}
