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
// Cells: how far the border follows a crease at least, and how far if it comes back to a crease
// behind a gap that is not large.
constexpr double ShortestRun = 48.0;
constexpr double ShortestRunAmongOthers = 400.0;
constexpr double LargestGap = 48.0;
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

/// Successive corners that moved to creases. Numbers go on behind the last corner.
struct Run
{
  std::size_t First;
  std::size_t End;
  /// The largest distance from the first corner, cells.
  double Length;
};

double GetDistance(const std::vector<Snapped>& corners, std::size_t first, std::size_t second)
{
  const lms3dPoint2& a = corners[first % corners.size()].Point;
  const lms3dPoint2& b = corners[second % corners.size()].Point;
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

// Returns none if all corners moved.
std::vector<Run> FindRuns(const std::vector<Snapped>& corners)
{
  const std::size_t count = corners.size();
  const auto isMoved = [&](std::size_t i) { return corners[i % count].IsMoved; };
  std::size_t start = 0;
  while (start < count && isMoved(start))
  {
    ++start;
  }
  std::vector<Run> runs;
  for (std::size_t i = start; start < count && i < start + count; ++i)
  {
    if (!isMoved(i))
    {
      continue;
    }
    Run run = { i, i, 0.0 };
    for (; isMoved(run.End); ++run.End)
    {
      run.Length = std::max(run.Length, GetDistance(corners, i, run.End));
    }
    runs.push_back(run);
    i = run.End;
  }
  return runs;
}

// A border that touches a crease now and then, or that leaves it again and again for beams that
// passed, is free to leave it.
void FreeShortRuns(std::vector<Snapped>& corners)
{
  const std::vector<Run> runs = FindRuns(corners);
  const std::size_t count = runs.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Run& run = runs[i];
    const Run& before = runs[(i + count - 1) % count];
    const Run& behind = runs[(i + 1) % count];
    const bool isAmongOthers = count > 1 &&
      (GetDistance(corners, before.End - 1, run.First) < LargestGap ||
        GetDistance(corners, run.End - 1, behind.First) < LargestGap);
    const bool stays = run.Length >= (isAmongOthers ? ShortestRunAmongOthers : ShortestRun);
    for (std::size_t corner = run.First; corner < run.End; ++corner)
    {
      corners[corner % corners.size()].IsMoved = stays;
    }
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
