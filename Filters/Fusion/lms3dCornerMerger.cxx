// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCornerMerger.h"

#include "Fusion/lms3dCornerPlaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace
{
// Cells: how far edges move outwards, in the order in which the steps are tried.
constexpr std::array<double, 3> Steps = { 1.0, 0.5, 0.25 };

using Triangle = lms3dCornerMerge::Triangle;
using Segment = std::array<lms3dPoint2, 2>;
using FourPoints = std::array<lms3dPoint2, 4>;

int GetOrientation(const Segment& segment, const lms3dPoint2& point)
{
  return lms3dGetOrientation(segment[0], segment[1], point);
}

// Whether two segments have a point in common.
bool DoMeet(const Segment& a, const Segment& b)
{
  return GetOrientation(a, b[0]) * GetOrientation(a, b[1]) <= 0 &&
    GetOrientation(b, a[0]) * GetOrientation(b, a[1]) <= 0;
}

/// The box of the outlines before and after a merge.
class Box
{
public:
  explicit Box(const lms3dCornerMerge& merge)
    : Low(merge.Corner)
    , High(merge.Corner)
  {
    for (const lms3dPoint2& point : merge.Before)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], point[axis]);
        this->High[axis] = std::max(this->High[axis], point[axis]);
      }
    }
  }

  bool Meets(const Segment& segment) const
  {
    return this->Meets(segment[0][0], segment[1][0], 0) &&
      this->Meets(segment[0][1], segment[1][1], 1);
  }

private:
  bool Meets(double from, double to, int axis) const
  {
    return std::min(from, to) <= this->High[axis] && std::max(from, to) >= this->Low[axis];
  }

  lms3dPoint2 Low;
  lms3dPoint2 High;
};

bool IsIn(const lms3dPoint2& point, const Triangle& triangle)
{
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  return orientation != 0 && lms3dIsInTriangle(point, triangle, orientation);
}

bool IsInAny(const lms3dPoint2& point, const std::array<Triangle, 3>& triangles)
{
  return std::any_of(triangles.begin(), triangles.end(),
    [&](const Triangle& triangle) { return IsIn(point, triangle); });
}

// Whether neither end of the outlines lies in the triangles of the other end.
bool AreEndsApart(const lms3dCornerMerge& merge, const std::array<Triangle, 3>& triangles)
{
  return !IsIn(merge.Before[0], triangles[1]) && !IsIn(merge.Before[0], triangles[2]) &&
    !IsIn(merge.Before[3], triangles[0]) && !IsIn(merge.Before[3], triangles[1]);
}
} // namespace

lms3dCornerMerger::lms3dCornerMerger(double tolerance, const lms3dFusedTile& tile,
  lms3dOutlineCorners& corners, lms3dBorderLimits& limits)
  : Tolerance(tolerance * tolerance)
  , Tile(tile)
  , Corners(corners)
  , Limits(limits)
  , IsQueued(corners.GetPoints().size(), false)
{
  for (Corner corner = 0; corner < corners.GetSize(); ++corner)
  {
    if (!corners.HasGone(corner))
    {
      this->Left.push_back(corner);
      this->Queue(corner);
    }
  }
}

void lms3dCornerMerger::Queue(Corner corner)
{
  if (!this->IsQueued[corner])
  {
    this->IsQueued[corner] = true;
    this->Queued.push_back(corner);
  }
}

void lms3dCornerMerger::Merge()
{
  // Merges queue more corners.
  std::size_t next = 0;
  while (next < this->Queued.size())
  {
    const Corner corner = this->Queued[next++];
    this->IsQueued[corner] = false;
    if (!this->Corners.HasGone(corner) && this->MergeAt(corner))
    {
      // The edges beside these corners are others now.
      const Corner previous = this->Corners.GetPrevious(corner);
      this->Queue(this->Corners.GetPrevious(previous));
      this->Queue(previous);
      this->Queue(corner);
      this->Queue(this->Corners.GetNext(corner));
    }
  }
  for (const Corner corner : this->Left)
  {
    if (!this->Corners.HasGone(corner) && !this->Corners.IsFixed(corner))
    {
      this->MoveOutwards(corner);
    }
  }
}

// Merges a corner with the next one.
bool lms3dCornerMerger::MergeAt(Corner corner)
{
  const Corner next = this->Corners.GetNext(corner);
  const Corner previous = this->Corners.GetPrevious(corner);
  if (this->Corners.IsFixed(corner) || this->Corners.IsFixed(next) ||
    this->Corners.IsOfTriangle(corner))
  {
    return false;
  }
  const FourPoints points = { this->Corners[previous], this->Corners[corner], this->Corners[next],
    this->Corners[this->Corners.GetNext(next)] };
  this->Far.reset();
  for (const lms3dPoint2& place : lms3dFindMergedPlaces(points))
  {
    const lms3dCornerMerge merge = { points, place };
    if (this->MayMerge(merge, corner, next))
    {
      this->Limits.Merge(merge, this->GetEdges(corner, next));
      this->Corners.Remove(next);
      this->Corners.Move(corner, place);
      return true;
    }
  }
  return false;
}

// A corner that moves is merged with itself.
void lms3dCornerMerger::MoveOutwards(Corner corner)
{
  const Triangle triangle = this->Corners.GetTriangle(corner);
  const auto& [before, point, behind] = triangle;
  const std::optional<lms3dPoint2> way = lms3dFindWayOutwards(triangle);
  this->Far.reset();
  for (std::size_t i = 0; way && i < Steps.size(); ++i)
  {
    const lms3dPoint2 place = { point[0] + Steps[i] * (*way)[0], point[1] + Steps[i] * (*way)[1] };
    const lms3dCornerMerge merge = { { before, point, point, behind }, place };
    if (this->MayMerge(merge, corner, corner))
    {
      this->Limits.Merge(merge, this->GetEdges(corner, corner));
      this->Corners.Move(corner, place);
      return;
    }
  }
}

// The cheap conditions come first.
bool lms3dCornerMerger::MayMerge(const lms3dCornerMerge& merge, Corner first, Corner last)
{
  return this->Tile.Has(merge.Corner) && merge.GetSquaredDistanceOfCorner() <= this->Tolerance &&
    lms3dGetOrientation(merge.Before[0], merge.Corner, merge.Before[3]) != 0 &&
    this->IsNearOutline(merge, first, last) &&
    this->Limits.MayMerge(merge, this->GetEdges(first, last)) && this->IsApart(merge, first, last);
}

// Whether the outline's first corners are within the tolerance of a merge. A corner that is too far
// from one place of a merge is often too far from the others.
bool lms3dCornerMerger::IsNearOutline(const lms3dCornerMerge& merge, Corner first, Corner last)
{
  const auto isNear = [&](const lms3dPoint2& point)
  { return merge.GetSquaredDistance(point) <= this->Tolerance; };
  if (this->Far && !isNear(this->Corners.GetFirstPoint(*this->Far)))
  {
    return false;
  }
  const Corner end = this->Corners.GetNext(last);
  const Corner far = this->Corners.FindFar(this->Corners.GetPrevious(first), end, isNear);
  this->Far = far == end ? std::nullopt : std::optional<Corner>(far);
  return far == end;
}

// The edges between two corners that are merged and their neighbours.
std::array<lms3dBorderLimits::Edge, 3> lms3dCornerMerger::GetEdges(Corner first, Corner last) const
{
  return { static_cast<std::size_t>(this->Corners.GetPrevious(first)),
    static_cast<std::size_t>(first), static_cast<std::size_t>(last) };
}

// Whether no other edge lies in the triangles between the outlines before and after the merge, nor
// meets them.
bool lms3dCornerMerger::IsApart(const lms3dCornerMerge& merge, Corner first, Corner last) const
{
  const Box box(merge);
  const std::array<Triangle, 3> triangles = merge.GetTriangles();
  const std::array<Segment, 4> sides = { { { merge.Before[0], merge.Corner },
    { merge.Before[3], merge.Corner }, { merge.Before[1], merge.Corner },
    { merge.Before[2], merge.Corner } } };
  const Corner previous = this->Corners.GetPrevious(first);
  const Corner behind = this->Corners.GetNext(last);
  return AreEndsApart(merge, triangles) &&
    std::all_of(this->Left.begin(), this->Left.end(),
      [&](Corner other)
      {
        const Corner end = this->Corners.GetNext(other);
        const Segment edge = { this->Corners[other], this->Corners[end] };
        if (this->Corners.HasGone(other) || other == previous || other == first || other == last ||
          !box.Meets(edge))
        {
          return true;
        }
        // Edges beside the merge have an end in common with a side.
        const bool isBefore = end == previous;
        const bool isBehind = other == behind;
        return (isBehind || !IsInAny(edge[0], triangles)) && !DoMeet(sides[2], edge) &&
          !DoMeet(sides[3], edge) &&
          (isBefore ? GetOrientation(sides[0], edge[0]) != 0 : !DoMeet(sides[0], edge)) &&
          (isBehind ? GetOrientation(sides[1], edge[1]) != 0 : !DoMeet(sides[1], edge));
      });
}
