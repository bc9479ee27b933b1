// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dFusedPlanes.h"

#include "Fusion/Cells/lms3dCoveredCells.h"
#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
// Whether a return is near enough to a triangle of a local map that is a region of its own.
bool IsAtVerbatim(const lms3dFusedPlane& plane, const lms3dVector& point, double bound)
{
  return plane.Verbatim.empty() ||
    std::any_of(plane.Verbatim.begin(), plane.Verbatim.end(),
      [&](const std::array<lms3dVector, 3>& corners)
      { return lms3dGetDistance(point, corners[0], corners[1], corners[2]) <= bound; });
}
} // namespace

bool lms3dFusedPlanes::Shows(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const
{
  const double bound = this->GetLargestDistance();
  if (lms3dDot(plane.Frame.GetNormal(), mapped.Direction) >= 0.0 ||
    !plane.Explains(mapped.Point, mapped.Direction, bound))
  {
    return false;
  }
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = lms3dGetCellOf(place[0]);
  const auto v = lms3dGetCellOf(place[1]);
  return plane.Raster.Has(&lms3dRasterBlock::May, u, v) &&
    !plane.Raster.Has(&lms3dRasterBlock::Open, u, v) &&
    !plane.Raster.Has(&lms3dRasterBlock::Passed, u, v) && IsAtVerbatim(plane, mapped.Point, bound);
}

bool lms3dFusedPlanes::AddToPlanes(const std::vector<int>& planes, const lms3dMappedReturn& mapped)
{
  return std::any_of(planes.begin(), planes.end(),
    [&](int plane)
    { return this->Shows(this->Planes[plane], mapped) && this->AddReturn(plane, mapped); });
}

std::vector<int> lms3dFusedPlanes::FindPlanesNear(
  const std::vector<lms3dMappedReturn>& returns, std::size_t end) const
{
  lms3dWorldBox box;
  for (const lms3dMappedReturn& mapped : returns)
  {
    box.Add(mapped.Point);
  }
  std::vector<int> planes = this->Boxes.Find(box, this->MaximumError, end);
  planes.erase(std::remove_if(planes.begin(), planes.end(),
                 [&](int plane)
                 {
                   return !this->Planes[plane].HasSurface ||
                     !this->Planes[plane].Frame.IsNear(box, this->MaximumError);
                 }),
    planes.end());
  return planes;
}

bool lms3dFusedPlanes::ShowShare(
  double share, const std::vector<int>& planes, const std::vector<lms3dMappedReturn>& returns) const
{
  const auto count = static_cast<double>(returns.size());
  const double allowed = count - share * count;
  double hidden = 0.0;
  // The plane that shows a return often shows the next one, too.
  auto last = planes.end();
  return std::all_of(returns.begin(), returns.end(),
    [&](const lms3dMappedReturn& mapped)
    {
      const auto shows = [&](int plane) { return this->Shows(this->Planes[plane], mapped); };
      if (last == planes.end() || !shows(*last))
      {
        last = std::find_if(planes.begin(), planes.end(), shows);
      }
      hidden += last != planes.end() ? 0.0 : 1.0;
      return hidden <= allowed;
    });
}

bool lms3dFusedPlanes::Covers(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const
{
  if (lms3dDot(plane.Frame.GetNormal(), mapped.Direction) >= 0.0 ||
    !plane.Explains(mapped.Point, mapped.Direction, this->GetLargestDistance()))
  {
    return false;
  }
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = lms3dGetCellOf(place[0]);
  const auto v = lms3dGetCellOf(place[1]);
  // The return may become one of the plane, so its own cell must lie in a block.
  if (plane.Raster.Find(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v)) < 0)
  {
    return false;
  }
  return this->IsCovered(plane, u, v, std::abs(plane.Frame.GetHeight(mapped.Point)));
}

bool lms3dFusedPlanes::IsMetBy(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const
{
  const double cosine = -lms3dDot(plane.Frame.GetNormal(), mapped.Direction);
  const double way = plane.Frame.GetHeight(mapped.Point) / cosine;
  // The way is infinite, or no number, if the beam is parallel to the plane.
  if (!(std::abs(way) <= this->MaximumError))
  {
    return false;
  }
  const lms3dPoint2 place =
    plane.Frame.ToCells(lms3dAdd(mapped.Point, lms3dScale(mapped.Direction, way)));
  return plane.Raster.Has(
    &lms3dRasterBlock::Covered, lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]));
}

bool lms3dFusedPlanes::IsCovered(
  const lms3dFusedPlane& plane, std::int32_t u, std::int32_t v, double distance) const
{
  return lms3dIsCovered(plane.Raster, plane.GetCellsOfTile(u, v), u, v,
    lms3dGetCoveredReach(distance, this->Cell, this->MaximumError));
}
