// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dCreaseSnapping.h"

#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Outlines/lms3dCreasePlaces.h"
#include "Fusion/Outlines/lms3dCreaseRuns.h"
#include "Fusion/Outlines/lms3dSegment2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace
{
// Cells: how far a return may lie outside a border that has moved to a crease.
constexpr double ReachOfReturns = 2.0;

bool IsNearAny(const lms3dPoint2& point, const std::vector<lms3dPoint2>& places, double distance)
{
  return std::any_of(places.begin(), places.end(),
    [&](const lms3dPoint2& place)
    { return std::hypot(place[0] - point[0], place[1] - point[1]) <= distance; });
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

using Triangle = std::array<lms3dPoint2, 3>;

// Whether each return in a triangle stays near a side of an outline, or inside.
bool KeepsReturns(
  const Triangle& triangle, const std::array<lms3dPoint2, 2>& side, const lms3dRegion& region)
{
  if (!region.HasAny(&lms3dRegionBlock::Must, lms3dGetTouchedBox(triangle)))
  {
    return true;
  }
  const lms3dSegment2 segment(side[0], side[1]);
  return lms3dForTouchedStrips(triangle,
    [&](const lms3dCellStrip& strip)
    {
      return region.ForCells(&lms3dRegionBlock::Must, strip,
        [&](std::int32_t u, std::int32_t v)
        {
          const lms3dPoint2 centre = { u + 0.5, v + 0.5 };
          return segment.GetSquaredDistance(centre) <= ReachOfReturns * ReachOfReturns ||
            lms3dGetOrientation(side[0], side[1], centre) >= 0;
        });
    });
}

// Whether a side of an outline may move over a triangle: inwards if returns stay near its new
// place, outwards if no beam passed.
bool MaySweep(
  const Triangle& triangle, const std::array<lms3dPoint2, 2>& side, const lms3dRegion& region)
{
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  if (orientation > 0)
  {
    return KeepsReturns(triangle, side, region);
  }
  return orientation == 0 ||
    !region.HasAny(&lms3dRegionBlock::Passed, lms3dGetTouchedBox(triangle)) ||
    lms3dForTouchedRows(triangle,
      [&](std::int32_t row, std::int32_t first, std::int32_t last)
      { return !region.HasAny(&lms3dRegionBlock::Passed, row, first, last); });
}

// Moves corners back until no side moves over a beam that passed, nor away from returns.
void MoveBack(
  const lms3dLoop& loop, const lms3dRegion& region, std::vector<lms3dSnappedCorner>& corners)
{
  const std::size_t count = loop.size();
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t next = (i + 1) % count;
      lms3dSnappedCorner& a = corners[i];
      lms3dSnappedCorner& b = corners[next];
      const std::array<lms3dPoint2, 2> side = { a.Point, b.Point };
      if (b.IsMoved && !MaySweep({ loop[i], loop[next], b.Point }, side, region))
      {
        b = { loop[next], false };
        isChanged = true;
      }
      if (a.IsMoved && !MaySweep({ loop[i], b.Point, a.Point }, { a.Point, b.Point }, region))
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
void Clean(std::vector<lms3dSnappedCorner>& corners)
{
  for (bool isChanged = true; isChanged && corners.size() >= 3;)
  {
    isChanged = false;
    std::vector<lms3dSnappedCorner> kept;
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
  const std::vector<lms3dCreaseLine>& creases, const lms3dRegion& region,
  const lms3dFusedTile& tile, const std::vector<lms3dPoint2>& places, double distance,
  std::vector<bool>& isFixed)
{
  std::vector<lms3dLoop> result;
  isFixed.clear();
  for (const lms3dLoop& loop : loops)
  {
    std::vector<lms3dSnappedCorner> corners;
    for (const lms3dPoint2& point : loop)
    {
      const std::optional<lms3dPoint2> place = lms3dFindPlaceOnCrease(point, creases, tile);
      const bool moves = place && tile.Has(*place) && !IsNearAny(point, places, distance) &&
        IsWayFree(point, *place, region);
      corners.push_back({ moves ? *place : point, moves });
    }
    MoveBack(loop, region, corners);
    Clean(corners);
    lms3dFreeShortRuns(corners);
    if (corners.size() < 3)
    {
      continue;
    }
    lms3dLoop moved;
    for (const lms3dSnappedCorner& corner : corners)
    {
      moved.push_back(corner.Point);
      isFixed.push_back(
        corner.IsMoved || tile.IsOnSide(corner.Point, 0) || tile.IsOnSide(corner.Point, 1));
    }
    result.push_back(moved);
  }
  return result;
}
