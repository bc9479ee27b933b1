// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dBorderLimits.h"

#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Outlines/lms3dSegment2.h"

#include <algorithm>
#include <iterator>

namespace
{
// Cells: a border need not cut off a return that is farther from all beams that passed.
constexpr int NearBeams = 3;
// Cells: how far from the region a corner moves outwards, along each axis.
constexpr double FarthestBorder = 2.0;

int GetOrientation(const lms3dCornerMerge::Triangle& triangle)
{
  return lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
}
} // namespace

lms3dBorderLimits::lms3dBorderLimits(const lms3dRegion& region, std::size_t edges, double reach)
  : Region(region)
  , Reach(reach * reach)
  , CutOff(edges)
{
}

bool lms3dBorderLimits::IsNearRegion(const lms3dPoint2& point) const
{
  return this->Region.HasAny(&lms3dRegionBlock::May,
    lms3dCellBox{ lms3dGetCellFrom(point[0] - FarthestBorder) - 1,
      lms3dGetCellOf(point[0] + FarthestBorder), lms3dGetCellFrom(point[1] - FarthestBorder) - 1,
      lms3dGetCellOf(point[1] + FarthestBorder) });
}

// The triangles of successive tries are nearly the same, so the row that decided last comes first.
bool lms3dBorderLimits::MayGain(const Triangle& triangle) const
{
  const lms3dCellBox box = lms3dGetTouchedBox(triangle);
  const bool mayHavePassed = this->Region.HasAny(&lms3dRegionBlock::Passed, box);
  if (!mayHavePassed && this->Region.HasBlocks(box))
  {
    return true;
  }
  if (mayHavePassed && box.Bottom <= this->PassedRow && this->PassedRow <= box.Top &&
    this->Region.HasAny(
      &lms3dRegionBlock::Passed, lms3dGetTouchedStrip(triangle, this->PassedRow, this->PassedRow)))
  {
    return false;
  }
  return lms3dForTouchedStrips(triangle,
    [this](const lms3dCellStrip& strip)
    { return this->Region.HasBlocks(strip) && !this->HasPassed(strip); });
}

bool lms3dBorderLimits::HasPassed(const lms3dCellStrip& strip) const
{
  return this->Region.HasAny(&lms3dRegionBlock::Passed, strip) &&
    !lms3dForRows(strip,
      [this](std::int32_t row, std::int32_t first, std::int32_t last)
      {
        this->PassedRow = row;
        return !this->Region.HasAny(&lms3dRegionBlock::Passed, row, first, last);
      });
}

bool lms3dBorderLimits::MayCutOff(const lms3dPoint2& place) const
{
  const auto u = lms3dGetCellOf(place[0]);
  const auto v = lms3dGetCellOf(place[1]);
  return !this->Region.Has(&lms3dRegionBlock::Far, u, v) &&
    this->Region.HasAny(&lms3dRegionBlock::Passed,
      lms3dCellBox{ u - NearBeams, u + NearBeams, v - NearBeams, v + NearBeams });
}

// Calls `visit` with the centres in the triangle of cells with a sure return. Stops, and returns
// false, if `visit` returns false.
template <typename Visitor>
bool lms3dBorderLimits::ForReturns(const Triangle& triangle, const Visitor& visit) const
{
  if (!this->Region.HasAny(&lms3dRegionBlock::Must, lms3dGetTouchedBox(triangle)))
  {
    return true;
  }
  return lms3dForCentreStrips(triangle,
    [&](const lms3dCellStrip& strip)
    {
      return this->Region.ForCells(&lms3dRegionBlock::Must, strip,
        [&](std::int32_t u, std::int32_t v) {
          return visit(lms3dPoint2{ u + 0.5, v + 0.5 });
        });
    });
}

void lms3dBorderLimits::AddReturns(const Triangle& triangle, Returns& returns) const
{
  this->ForReturns(triangle,
    [&](const lms3dPoint2& place)
    {
      returns.push_back(place);
      return true;
    });
}

bool lms3dBorderLimits::MayJoin(const Triangle& triangle, Edge first, Edge second) const
{
  if (GetOrientation(triangle) < 0)
  {
    return this->MayGain(triangle);
  }
  const lms3dSegment2 line(triangle[0], triangle[2]);
  const auto isNear = [&](const lms3dPoint2& place)
  { return line.GetSquaredDistance(place) <= this->Reach; };
  return std::all_of(this->CutOff[first].begin(), this->CutOff[first].end(), isNear) &&
    std::all_of(this->CutOff[second].begin(), this->CutOff[second].end(), isNear) &&
    this->ForReturns(
      triangle, [&](const lms3dPoint2& place) { return isNear(place) && this->MayCutOff(place); });
}

void lms3dBorderLimits::Join(const Triangle& triangle, Edge first, Edge second)
{
  Returns& joined = this->CutOff[first];
  joined.insert(joined.end(), this->CutOff[second].begin(), this->CutOff[second].end());
  this->CutOff[second] = {};
  const int orientation = GetOrientation(triangle);
  if (orientation > 0)
  {
    this->AddReturns(triangle, joined);
  }
  else if (orientation < 0)
  {
    const auto isInside = [&](const lms3dPoint2& place)
    { return lms3dGetOrientation(triangle[0], triangle[2], place) >= 0; };
    joined.erase(std::remove_if(joined.begin(), joined.end(), isInside), joined.end());
  }
}

// Whether the region may gain or lose a triangle of a merge.
bool lms3dBorderLimits::MayChange(const Triangle& triangle, const lms3dCornerMerge& merge) const
{
  const auto mayLose = [&](const lms3dPoint2& place)
  {
    return merge.IsInside(place) ||
      (merge.GetSquaredDistance(place) <= this->Reach && this->MayCutOff(place));
  };
  const int orientation = GetOrientation(triangle);
  return orientation == 0 ||
    (orientation < 0 ? this->MayGain(triangle) : this->ForReturns(triangle, mayLose));
}

bool lms3dBorderLimits::MayMerge(
  const lms3dCornerMerge& merge, const std::vector<Edge>& edges) const
{
  const auto isNear = [&](const lms3dPoint2& place)
  { return merge.GetSquaredDistance(place) <= this->Reach; };
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Returns& returns = this->CutOff[edges[i]];
    if (!std::all_of(returns.begin(), returns.end(), isNear) ||
      !this->MayChange(merge.GetTriangle(i), merge))
    {
      return false;
    }
  }
  return true;
}

void lms3dBorderLimits::Merge(const lms3dCornerMerge& merge, const std::vector<Edge>& edges)
{
  Returns all;
  Returns lost;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    all.insert(all.end(), this->CutOff[edges[i]].begin(), this->CutOff[edges[i]].end());
    this->CutOff[edges[i]] = {};
    const Triangle triangle = merge.GetTriangle(i);
    if (GetOrientation(triangle) > 0)
    {
      this->AddReturns(triangle, lost);
    }
  }
  std::copy_if(lost.begin(), lost.end(), std::back_inserter(all),
    [&](const lms3dPoint2& place) { return !merge.IsInside(place); });
  const lms3dSegment2 first(merge.Before.front(), merge.Corner);
  const lms3dSegment2 second(merge.Corner, merge.Before.back());
  for (const lms3dPoint2& place : all)
  {
    const bool isAtFirst = first.GetSquaredDistance(place) <= second.GetSquaredDistance(place);
    this->CutOff[edges[isAtFirst ? 0 : 1]].push_back(place);
  }
}
