// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dCornerMerger.h"

#include "Fusion/Outlines/lms3dCornerPlaces.h"
#include "Fusion/Outlines/lms3dMergeClearance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace
{
// How far corners move along a way outwards, in the order in which the steps are tried. A way moves
// edges by one cell.
constexpr std::array<double, 6> Steps = { 2.0, 1.5, 1.0, 0.75, 0.5, 0.25 };

// How many corners become one at most. Two are tried everywhere before more are.
constexpr std::size_t ChainLimit = 5;
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
    }
  }
}

void lms3dCornerMerger::Merge()
{
  for (const std::size_t longest : { std::size_t{ 2 }, ChainLimit })
  {
    for (const Corner corner : this->Left)
    {
      this->Queue(corner);
    }
    this->MergeQueued(longest);
    this->DropGone();
  }
  this->MoveOutwards();
}

void lms3dCornerMerger::MoveOutwards()
{
  for (const Corner corner : this->Left)
  {
    if (!this->Corners.IsFixed(corner))
    {
      this->MoveOutwards(corner);
    }
  }
}

// Each merge looks at all corners that are left.
void lms3dCornerMerger::DropGone()
{
  this->Left.erase(std::remove_if(this->Left.begin(), this->Left.end(),
                     [this](Corner corner) { return this->Corners.HasGone(corner); }),
    this->Left.end());
}

// Merges queue more corners.
void lms3dCornerMerger::MergeQueued(std::size_t longest)
{
  std::size_t next = 0;
  while (next < this->Queued.size())
  {
    const Corner corner = this->Queued[next++];
    this->IsQueued[corner] = false;
    if (!this->Corners.HasGone(corner) && this->MergeAt(corner, longest))
    {
      this->QueueBefore(this->Corners.GetNext(this->Chain.back()), longest + 2);
    }
  }
  this->Queued.clear();
}

// Queues a corner and some before it, since edges beside them are others now.
void lms3dCornerMerger::QueueBefore(Corner corner, std::size_t count)
{
  for (std::size_t i = 0; i <= count; ++i)
  {
    this->Queue(corner);
    corner = this->Corners.GetPrevious(corner);
  }
}

// Merges a corner with the ones behind it.
bool lms3dCornerMerger::MergeAt(Corner corner, std::size_t longest)
{
  this->Chain = { this->Corners.GetPrevious(corner), corner };
  this->Points = { this->Corners[this->Chain[0]], this->Corners[corner] };
  for (std::size_t count = 2; count <= longest && !this->Corners.IsFixed(this->Chain.back());
       ++count)
  {
    const Corner next = this->Corners.GetNext(this->Chain.back());
    const Corner behind = this->Corners.GetNext(next);
    if (next == this->Chain.front() || behind == this->Chain.front())
    {
      return false;
    }
    this->Chain.push_back(next);
    this->Points.push_back(this->Corners[next]);
    if (this->MergeChain(behind))
    {
      return true;
    }
  }
  return false;
}

bool lms3dCornerMerger::MergeChain(Corner behind)
{
  std::vector<Corner> chain = this->Chain;
  chain.push_back(behind);
  lms3dCornerMerge merge = { this->Points, {} };
  merge.Before.push_back(this->Corners[behind]);
  this->Prepare(chain);
  const bool isFixed = this->Corners.IsFixed(this->Chain.back());
  for (const lms3dPoint2& place :
    isFixed ? std::vector<lms3dPoint2>{ this->Points.back() } : lms3dFindMergedPlaces(merge.Before))
  {
    merge.Corner = place;
    if (!lms3dIsSharpCorner({ merge.Before.front(), place, merge.Before.back() }) &&
      this->MayMerge(merge, chain))
    {
      this->Apply(merge, chain);
      return true;
    }
  }
  return false;
}

// The edges of a chain, first those that stay.
void lms3dCornerMerger::Prepare(const std::vector<Corner>& chain)
{
  this->Far.reset();
  this->Edges = { static_cast<std::size_t>(chain.front()),
    static_cast<std::size_t>(chain[chain.size() - 2]) };
  this->Edges.insert(this->Edges.end(), chain.begin() + 1, chain.end() - 2);
}

// The last of the corners between the ends of a chain stays.
void lms3dCornerMerger::Apply(const lms3dCornerMerge& merge, const std::vector<Corner>& chain)
{
  const Corner kept = chain[chain.size() - 2];
  this->Limits.Merge(merge, this->Edges);
  for (std::size_t i = 1; i + 2 < chain.size(); ++i)
  {
    this->Corners.Remove(chain[i]);
  }
  this->Corners.Move(kept, merge.Corner);
}

// The three ways are found before the corner moves.
void lms3dCornerMerger::MoveOutwards(Corner corner)
{
  for (const lms3dPoint2& way : lms3dFindWaysOutwards(this->Corners.GetTriangle(corner)))
  {
    this->MoveAlong(corner, way);
  }
}

// A corner that moves is merged with itself.
void lms3dCornerMerger::MoveAlong(Corner corner, const lms3dPoint2& way)
{
  const auto [before, point, behind] = this->Corners.GetTriangle(corner);
  const std::vector<Corner> chain = { this->Corners.GetPrevious(corner), corner,
    this->Corners.GetNext(corner) };
  this->Prepare(chain);
  for (const double step : Steps)
  {
    const lms3dPoint2 place = { point[0] + step * way[0], point[1] + step * way[1] };
    const lms3dCornerMerge merge = { { before, point, behind }, place };
    if (this->Limits.IsNearRegion(place) && this->MayMerge(merge, chain))
    {
      this->Apply(merge, chain);
      return;
    }
  }
}

// The cheap conditions come first.
bool lms3dCornerMerger::MayMerge(const lms3dCornerMerge& merge, const std::vector<Corner>& chain)
{
  return this->Tile.Has(merge.Corner) && merge.GetSquaredDistanceOfCorner() <= this->Tolerance &&
    lms3dGetOrientation(merge.Before.front(), merge.Corner, merge.Before.back()) != 0 &&
    !this->IsFar(merge) && this->IsNearOutline(merge, chain) &&
    this->Limits.MayMerge(merge, this->Edges) && this->AreNeighboursNear(merge, chain) &&
    lms3dIsMergeApart(merge, chain, this->Left, this->Corners);
}

// A corner that is too far from one place of a merge is often too far from the others.
bool lms3dCornerMerger::IsFar(const lms3dCornerMerge& merge) const
{
  return this->Far &&
    merge.GetSquaredDistance(this->Corners.GetFirstPoint(*this->Far)) > this->Tolerance;
}

// Whether the outline's first corners are within the tolerance of a merge.
bool lms3dCornerMerger::IsNearOutline(
  const lms3dCornerMerge& merge, const std::vector<Corner>& chain)
{
  const lms3dSegment2 first(merge.Before.front(), merge.Corner);
  const lms3dSegment2 second(merge.Corner, merge.Before.back());
  const Corner far = this->Corners.FindFar(chain.front(), chain.back(),
    [&](const lms3dPoint2& point)
    {
      return first.GetSquaredDistance(point) <= this->Tolerance ||
        second.GetSquaredDistance(point) <= this->Tolerance;
    });
  this->Far = far == chain.back() ? std::nullopt : std::optional<Corner>(far);
  return far == chain.back();
}

// The same for the first corners before and behind a chain, and at its ends: the edges of the chain
// may be the only ones that are near them. Each first corner stays near the edge that took its
// place, or near one beside that.
bool lms3dCornerMerger::AreNeighboursNear(
  const lms3dCornerMerge& merge, const std::vector<Corner>& chain) const
{
  const Corner first = chain.front();
  const Corner last = chain.back();
  const Corner before = this->Corners.GetPrevious(first);
  const Corner behind = this->Corners.GetNext(last);
  const lms3dPoint2& start =
    before == last ? merge.Corner : this->Corners[this->Corners.GetPrevious(before)];
  const lms3dPoint2& end =
    behind == first ? merge.Corner : this->Corners[this->Corners.GetNext(behind)];
  const ThreeEdges edgesBefore = { start, this->Corners[before], this->Corners[first],
    merge.Corner };
  const ThreeEdges edgesOfLast = { this->Corners[first], merge.Corner, this->Corners[last],
    this->Corners[behind] };
  const ThreeEdges edgesBehind = { merge.Corner, this->Corners[last], this->Corners[behind], end };
  return this->AreNear(last, last, edgesOfLast) && this->AreNear(before, first, edgesBefore) &&
    this->AreNear(last, behind, edgesBehind);
}

// Whether the outline's first corners behind one, up to another, are near edges.
bool lms3dCornerMerger::AreNear(Corner from, Corner to, const ThreeEdges& points) const
{
  const std::array<lms3dSegment2, 3> edges = { lms3dSegment2(points[0], points[1]),
    lms3dSegment2(points[1], points[2]), lms3dSegment2(points[2], points[3]) };
  const auto isNear = [&](const lms3dPoint2& point)
  {
    return std::any_of(edges.begin(), edges.end(),
      [&](const lms3dSegment2& edge) { return edge.GetSquaredDistance(point) <= this->Tolerance; });
  };
  return isNear(this->Corners.GetFirstPoint(to)) &&
    (from == to || this->Corners.FindFar(from, to, isNear) == to);
}
