// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCutReturns.h"

#include "Fusion/lms3dRasterRows.h"
#include "Fusion/lms3dSegment2.h"

#include <algorithm>

namespace
{
// Cells: a border need not cut off a return that is farther from all beams that passed.
constexpr int NearBeams = 3;
} // namespace

lms3dCutReturns::lms3dCutReturns(const lms3dRegion& region, std::size_t edges)
  : Region(region)
  , Returns(edges)
{
}

// Calls `visit` with the centres in the triangle of cells with a sure return. Stops, and returns
// false, if `visit` returns false.
template <typename Visitor>
bool lms3dCutReturns::ForReturns(const Triangle& triangle, const Visitor& visit) const
{
  if (!this->Region.HasAny(&lms3dRegionBlock::Must, lms3dGetTouchedBox(triangle)))
  {
    return true;
  }
  return lms3dForCentreStrips(triangle,
    [&](const lms3dCellStrip& strip)
    {
      return !this->Region.HasAny(&lms3dRegionBlock::Must, strip) ||
        lms3dForRows(strip,
          [&](std::int32_t row, std::int32_t first, std::int32_t last)
          {
            for (std::int32_t cell = first; cell <= last; ++cell)
            {
              if (this->Region.Has(&lms3dRegionBlock::Must, cell, row) &&
                !visit(lms3dPoint2{ cell + 0.5, row + 0.5 }))
              {
                return false;
              }
            }
            return true;
          });
    });
}

bool lms3dCutReturns::MayCut(const Triangle& triangle, std::size_t first, std::size_t second) const
{
  const lms3dSegment2 line(triangle[0], triangle[2]);
  const auto isNear = [&](const lms3dPoint2& place)
  { return line.GetSquaredDistance(place) <= this->Reach; };
  const auto mayGo = [&](const lms3dPoint2& place)
  {
    const auto u = lms3dGetCellOf(place[0]);
    const auto v = lms3dGetCellOf(place[1]);
    return isNear(place) && !this->Region.Has(&lms3dRegionBlock::Far, u, v) &&
      this->Region.HasAny(&lms3dRegionBlock::Passed,
        lms3dCellBox{ u - NearBeams, u + NearBeams, v - NearBeams, v + NearBeams });
  };
  return std::all_of(this->Returns[first].begin(), this->Returns[first].end(), isNear) &&
    std::all_of(this->Returns[second].begin(), this->Returns[second].end(), isNear) &&
    this->ForReturns(triangle, mayGo);
}

void lms3dCutReturns::Join(const Triangle& triangle, std::size_t first, std::size_t second)
{
  std::vector<lms3dPoint2>& joined = this->Returns[first];
  joined.insert(joined.end(), this->Returns[second].begin(), this->Returns[second].end());
  this->Returns[second] = {};
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  if (orientation > 0)
  {
    this->ForReturns(triangle,
      [&](const lms3dPoint2& place)
      {
        joined.push_back(place);
        return true;
      });
  }
  else if (orientation < 0)
  {
    const auto isInside = [&](const lms3dPoint2& place)
    { return lms3dGetOrientation(triangle[0], triangle[2], place) >= 0; };
    joined.erase(std::remove_if(joined.begin(), joined.end(), isInside), joined.end());
  }
}
