// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dCreasePlaces.h"

#include "Fusion/Cells/lms3dBox2.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
// Cells: how far a corner may be from a crease, from the end of its part, and from a meeting point
// of creases.
constexpr double Reach = 8.0;
constexpr double ReachAlong = 8.0;
constexpr double ReachOfMeeting = 12.0;
// The sine of the smallest angle between lines that meet.
constexpr double SmallestSine = 0.1;
// Cells: creases with planes that are nearly the same count as one, the first of them.
constexpr double LargestDifference = 1.5;

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

/// The creases near a corner: the nearest, and the next one.
struct NearCreases
{
  const lms3dCreaseLine* First = nullptr;
  const lms3dCreaseLine* Second = nullptr;
  Foot FootOfFirst = {};
  Foot FootOfSecond = {};
};

// Whether a crease is nearly the same as one that was found.
bool IsSame(const lms3dCreaseLine* found, const Foot& footOfFound, const lms3dCreaseLine& crease,
  const Foot& foot)
{
  if (!found || Intersect(*found, crease))
  {
    return false;
  }
  const lms3dPoint2 first = GetPoint(*found, footOfFound.Along);
  const lms3dPoint2 second = GetPoint(crease, foot.Along);
  return std::hypot(second[0] - first[0], second[1] - first[1]) <= LargestDifference;
}

NearCreases FindCreases(const lms3dPoint2& point, const std::vector<lms3dCreaseLine>& creases)
{
  NearCreases near;
  for (const lms3dCreaseLine& crease : creases)
  {
    const Foot foot = GetFoot(point, crease);
    if (foot.Distance > Reach || !IsOn(crease.Parts.Seen, foot.Along) ||
      IsSame(near.First, near.FootOfFirst, crease, foot) ||
      IsSame(near.Second, near.FootOfSecond, crease, foot))
    {
      continue;
    }
    if (!near.First || foot.Distance < near.FootOfFirst.Distance)
    {
      near.Second = near.First;
      near.FootOfSecond = near.FootOfFirst;
      near.First = &crease;
      near.FootOfFirst = foot;
    }
    else if (!near.Second || foot.Distance < near.FootOfSecond.Distance)
    {
      near.Second = &crease;
      near.FootOfSecond = foot;
    }
  }
  return near;
}

bool IsNearMeeting(const lms3dPoint2& point, const std::optional<lms3dPoint2>& meeting)
{
  return meeting &&
    std::hypot((*meeting)[0] - point[0], (*meeting)[1] - point[1]) <= ReachOfMeeting;
}

// Whether a part of a crease is so near to a box that a corner in the box may be near the part.
bool IsNear(const lms3dCreaseLine& crease, const lms3dBox2& box)
{
  return std::any_of(crease.Parts.Seen.begin(), crease.Parts.Seen.end(),
    [&](const auto& part)
    {
      lms3dBox2 ends;
      ends.Add(GetPoint(crease, part.first));
      ends.Add(GetPoint(crease, part.second));
      return ends.IsNear(box, 2.0 * std::max(Reach, ReachAlong));
    });
}

// A corner on a side of a tile stays on it, so that both tiles beside it have the same corner.
std::optional<lms3dPoint2> FindPlaceOnSide(
  const lms3dPoint2& point, const lms3dCreaseLine& crease, int axis)
{
  const lms3dCreaseLine side = { point, { axis == 0 ? 0.0 : 1.0, axis == 0 ? 1.0 : 0.0 }, {} };
  std::optional<lms3dPoint2> meeting = Intersect(crease, side);
  if (!meeting || !IsNearMeeting(point, meeting))
  {
    return {};
  }
  (*meeting)[axis] = point[axis];
  return meeting;
}
} // namespace

std::optional<lms3dPoint2> lms3dFindPlaceOnCrease(
  const lms3dPoint2& point, const std::vector<lms3dCreaseLine>& creases, const lms3dFusedTile& tile)
{
  const NearCreases near = FindCreases(point, creases);
  const bool isOnU = tile.IsOnSide(point, 0);
  const bool isOnV = tile.IsOnSide(point, 1);
  if (!near.First || (isOnU && isOnV))
  {
    return {};
  }
  if (isOnU || isOnV)
  {
    return FindPlaceOnSide(point, *near.First, isOnU ? 0 : 1);
  }
  if (near.Second)
  {
    const std::optional<lms3dPoint2> meeting = Intersect(*near.First, *near.Second);
    if (IsNearMeeting(point, meeting))
    {
      return meeting;
    }
  }
  return GetPoint(*near.First, near.FootOfFirst.Along);
}

std::vector<lms3dCreaseLine> lms3dFindCreasesNear(
  const std::vector<lms3dLoop>& outlines, const std::vector<lms3dCreaseLine>& creases)
{
  lms3dBox2 box;
  for (const lms3dLoop& loop : outlines)
  {
    std::for_each(loop.begin(), loop.end(), [&](const lms3dPoint2& point) { box.Add(point); });
  }
  std::vector<lms3dCreaseLine> near;
  std::copy_if(creases.begin(), creases.end(), std::back_inserter(near),
    [&](const lms3dCreaseLine& crease) { return IsNear(crease, box); });
  return near;
}
