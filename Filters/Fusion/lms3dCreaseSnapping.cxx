// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCreaseSnapping.h"

#include "Fusion/lms3dCreasePlaces.h"
#include "Fusion/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace
{
// Cells: how far the border follows a crease at least.
constexpr double ShortestRun = 48.0;
// Cells: how near to a place corners stay where they are.
constexpr double ReachOfPlaces = 24.0;

bool IsNearAny(const lms3dPoint2& point, const std::vector<lms3dPoint2>& places)
{
  return std::any_of(places.begin(), places.end(),
    [&](const lms3dPoint2& place)
    { return std::hypot(place[0] - point[0], place[1] - point[1]) <= ReachOfPlaces; });
}

// Samples the way at half cells.
bool IsWayFree(const lms3dPoint2& from, const lms3dPoint2& to, const lms3dRegion& region)
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
  bool IsMoved;
};

// Whether a side of an outline moves inwards, or no beam passed where it moves over.
bool IsSweepFree(const std::array<lms3dPoint2, 3>& triangle, const lms3dRegion& region)
{
  return lms3dGetOrientation(triangle[0], triangle[1], triangle[2]) >= 0 ||
    lms3dForTouchedRows(triangle,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      { return !region.HasAny(&lms3dRasterBlock::Passed, row, first, last); });
}

// Moves corners back until no side moves over a beam that passed.
void MoveBack(const lms3dLoop& loop, const lms3dRegion& region, std::vector<Snapped>& corners)
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
      if (b.IsMoved && !IsSweepFree({ loop[i], loop[next], b.Point }, region))
      {
        b = { loop[next], false };
        isChanged = true;
      }
      if (a.IsMoved && !IsSweepFree({ loop[i], b.Point, a.Point }, region))
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

// A border that touches a crease now and then is free to leave it.
void FreeShortRuns(std::vector<Snapped>& corners)
{
  const std::size_t count = corners.size();
  std::size_t start = 0;
  while (start < count && corners[start].IsMoved)
  {
    ++start;
  }
  for (std::size_t i = start; i < start + count && start < count;)
  {
    std::size_t end = i;
    double length = 0.0;
    for (; corners[end % count].IsMoved; ++end)
    {
      const lms3dPoint2& a = corners[i % count].Point;
      const lms3dPoint2& b = corners[end % count].Point;
      length = std::max(length, std::hypot(b[0] - a[0], b[1] - a[1]));
    }
    for (; i < end; ++i)
    {
      corners[i % count].IsMoved = length >= ShortestRun;
    }
    ++i;
  }
}
} // namespace

std::vector<lms3dLoop> lms3dSnapToCreases(const std::vector<lms3dLoop>& loops,
  const std::vector<lms3dCreaseLine>& creases, const lms3dRegion& region,
  const lms3dFusedTile& tile, const std::vector<lms3dPoint2>& places, std::vector<bool>& isFixed)
{
  std::vector<lms3dLoop> result;
  isFixed.clear();
  for (const lms3dLoop& loop : loops)
  {
    std::vector<Snapped> corners;
    for (const lms3dPoint2& point : loop)
    {
      const std::optional<lms3dPoint2> place = lms3dFindPlaceOnCrease(point, creases, tile);
      const bool moves =
        place && tile.Has(*place) && !IsNearAny(point, places) && IsWayFree(point, *place, region);
      corners.push_back({ moves ? *place : point, moves });
    }
    MoveBack(loop, region, corners);
    Clean(corners);
    FreeShortRuns(corners);
    if (corners.size() < 3)
    {
      continue;
    }
    lms3dLoop moved;
    for (const Snapped& corner : corners)
    {
      moved.push_back(corner.Point);
      isFixed.push_back(
        corner.IsMoved || tile.IsOnSide(corner.Point, 0) || tile.IsOnSide(corner.Point, 1));
    }
    result.push_back(moved);
  }
  return result;
}
