// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dIslands.h"

#include "Fusion/Cells/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
// Cells: the length of the longest bridge, and half of its width.
constexpr double LargestGap = 32.0;
constexpr double HalfWidth = 0.6;

using Rectangle = std::array<lms3dPoint2, 4>;

/// A corner of the outline of an island.
struct Corner
{
  lms3dPoint2 Point;
  int Island;
};

/// The shortest way between two islands.
struct Bridge
{
  double Square;
  lms3dPoint2 From;
  lms3dPoint2 To;
  int First;
  int Second;

  bool operator<(const Bridge& other) const
  {
    return std::tie(this->Square, this->From, this->To) <
      std::tie(other.Square, other.From, other.To);
  }
};

// The product of two vectors from a point: twice the area of a triangle.
double GetCross(const lms3dPoint2& from, const lms3dPoint2& a, const lms3dPoint2& b)
{
  return (a[0] - from[0]) * (b[1] - from[1]) - (a[1] - from[1]) * (b[0] - from[0]);
}

// The corners at which islands are convex, from left to right.
std::vector<Corner> FindCorners(const std::vector<const lms3dLoop*>& islands)
{
  std::vector<Corner> corners;
  for (std::size_t island = 0; island < islands.size(); ++island)
  {
    const lms3dLoop& loop = *islands[island];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const lms3dPoint2& before = loop[(i + loop.size() - 1) % loop.size()];
      if (GetCross(before, loop[i], loop[(i + 1) % loop.size()]) > 0.0)
      {
        corners.push_back({ loop[i], static_cast<int>(island) });
      }
    }
  }
  std::sort(corners.begin(), corners.end(),
    [](const Corner& a, const Corner& b)
    { return std::tie(a.Point, a.Island) < std::tie(b.Point, b.Island); });
  return corners;
}

// The shortest bridges between islands, from short to long.
std::vector<Bridge> FindBridges(const std::vector<Corner>& corners)
{
  std::map<std::pair<int, int>, Bridge> shortest;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Corner& a = corners[i];
    for (std::size_t j = i + 1;
         j < corners.size() && corners[j].Point[0] - a.Point[0] <= LargestGap; ++j)
    {
      const Corner& b = corners[j];
      const double du = b.Point[0] - a.Point[0];
      const double dv = b.Point[1] - a.Point[1];
      const double square = du * du + dv * dv;
      if (a.Island == b.Island || square > LargestGap * LargestGap)
      {
        continue;
      }
      const Bridge bridge = { square, a.Point, b.Point, a.Island, b.Island };
      const auto [place, isNew] = shortest.try_emplace(std::minmax(a.Island, b.Island), bridge);
      place->second = std::min(place->second, bridge);
    }
  }
  std::vector<Bridge> bridges;
  bridges.reserve(shortest.size());
  for (const auto& [islands, bridge] : shortest)
  {
    bridges.push_back(bridge);
  }
  std::sort(bridges.begin(), bridges.end());
  return bridges;
}

// The square around the point in which two islands touch meets all four cells around it.
Rectangle GetSquare(const lms3dPoint2& point)
{
  const auto& [u, v] = point;
  return { { { u - HalfWidth, v - HalfWidth }, { u + HalfWidth, v - HalfWidth },
    { u + HalfWidth, v + HalfWidth }, { u - HalfWidth, v + HalfWidth } } };
}

Rectangle GetCells(const Bridge& bridge)
{
  if (bridge.Square == 0.0)
  {
    return GetSquare(bridge.From);
  }
  const double length = std::max(1.0, std::sqrt(bridge.Square));
  const double du = HalfWidth * (bridge.To[0] - bridge.From[0]) / length;
  const double dv = HalfWidth * (bridge.To[1] - bridge.From[1]) / length;
  return { { { bridge.From[0] - du + dv, bridge.From[1] - dv - du },
    { bridge.To[0] + du + dv, bridge.To[1] + dv - du },
    { bridge.To[0] + du - dv, bridge.To[1] + dv + du },
    { bridge.From[0] - du - dv, bridge.From[1] - dv + du } } };
}

bool IsFree(const Rectangle& cells, const lms3dRaster& raster, const lms3dRegion& region)
{
  return lms3dForTouchedStrips(cells,
    [&](const lms3dCellStrip& strip)
    {
      return region.HasBlocks(strip) && !region.HasAny(&lms3dRegionBlock::Passed, strip) &&
        !raster.HasAny(&lms3dRasterBlock::Open, strip);
    });
}

// Whether a bridge leads from one side of a crease to the other.
bool Crosses(const Bridge& bridge, const lms3dCreaseLine& crease)
{
  const lms3dPoint2 ahead = { crease.Point[0] + crease.Direction[0],
    crease.Point[1] + crease.Direction[1] };
  const double from = GetCross(crease.Point, ahead, bridge.From);
  const double to = GetCross(crease.Point, ahead, bridge.To);
  if (from * to >= 0.0)
  {
    return false;
  }
  const double share = from / (from - to);
  double along = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place = bridge.From[axis] + share * (bridge.To[axis] - bridge.From[axis]);
    along += (place - crease.Point[axis]) * crease.Direction[axis];
  }
  return std::any_of(crease.Parts.Drawn.begin(), crease.Parts.Drawn.end(),
    [&](const auto& part) { return along >= part.first && along <= part.second; });
}

void Fill(const Rectangle& cells, lms3dRegion& region)
{
  lms3dForTouchedStrips(cells,
    [&](const lms3dCellStrip& strip)
    {
      region.Set(&lms3dRegionBlock::May, strip, true);
      return true;
    });
}

int FindRoot(std::vector<int>& parents, int island)
{
  while (parents[island] != island)
  {
    parents[island] = parents[parents[island]];
    island = parents[island];
  }
  return island;
}
} // namespace

bool lms3dJoinIslands(const std::vector<lms3dLoop>& outlines, const lms3dRaster& raster,
  const std::vector<lms3dCreaseLine>& creases, lms3dRegion& region)
{
  std::vector<const lms3dLoop*> islands;
  for (const lms3dLoop& loop : outlines)
  {
    if (lms3dIsAroundCells(loop))
    {
      islands.push_back(&loop);
    }
  }
  if (islands.size() < 2)
  {
    return false;
  }
  std::vector<int> parents(islands.size());
  std::iota(parents.begin(), parents.end(), 0);
  bool isJoined = false;
  for (const Bridge& bridge : FindBridges(FindCorners(islands)))
  {
    const int first = FindRoot(parents, bridge.First);
    const int second = FindRoot(parents, bridge.Second);
    const Rectangle cells = GetCells(bridge);
    if (first != second && IsFree(cells, raster, region) &&
      std::none_of(creases.begin(), creases.end(),
        [&](const lms3dCreaseLine& crease) { return Crosses(bridge, crease); }))
    {
      parents[second] = first;
      Fill(cells, region);
      isJoined = true;
    }
  }
  return isJoined;
}
