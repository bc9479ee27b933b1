// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dFusedRegions.h"

#include "vtkLMS3DMapFusion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace
{
using Triangle = std::array<vtkIdType, 3>;
using TrianglesOfRegions = std::map<std::uint32_t, std::vector<Triangle>>;

// Also of the regions without triangles.
TrianglesOfRegions SortTriangles(vtkPolyData* delta)
{
  TrianglesOfRegions sorted;
  vtkDataArray* const changed = delta->GetFieldData()->GetArray("ChangedRegions");
  for (vtkIdType i = 0; i < changed->GetNumberOfTuples(); ++i)
  {
    sorted[static_cast<std::uint32_t>(changed->GetTuple1(i))];
  }
  vtkDataArray* const ids = delta->GetCellData()->GetArray("RegionId");
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < delta->GetNumberOfPolys(); ++i)
  {
    delta->GetPolys()->GetCellAtId(i, corners);
    sorted[static_cast<std::uint32_t>(ids->GetTuple1(i))].push_back(
      { corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
  return sorted;
}

double GetArea(const Triangle& triangle, vtkPolyData* map)
{
  std::array<std::array<double, 3>, 3> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    map->GetPoint(triangle[i], corners[i].data());
  }
  return vtkTriangle::TriangleArea(corners[0].data(), corners[1].data(), corners[2].data());
}

// The points of a region lie together in the output.
void TakeMesh(const std::vector<Triangle>& triangles, vtkPolyData* delta,
  const LMS3D::Vector3& origin, lms3dFusedRegion& region)
{
  vtkIdType first = triangles.front().front();
  vtkIdType last = first;
  for (const Triangle& triangle : triangles)
  {
    const auto [least, greatest] = std::minmax_element(triangle.begin(), triangle.end());
    first = std::min(first, *least);
    last = std::max(last, *greatest);
  }
  for (const Triangle& triangle : triangles)
  {
    std::transform(triangle.begin(), triangle.end(), std::back_inserter(region.Triangles),
      [first](vtkIdType corner) { return static_cast<std::uint32_t>(corner - first); });
    region.Area += GetArea(triangle, delta);
  }
  for (vtkIdType i = first; i <= last; ++i)
  {
    std::array<double, 3> point{};
    delta->GetPoint(i, point.data());
    region.Points.push_back(static_cast<float>(point[0] - origin.x));
    region.Points.push_back(static_cast<float>(point[1] - origin.y));
    region.Points.push_back(static_cast<float>(point[2] - origin.z));
  }
}
bool HaveSameMesh(const lms3dFusedRegion& a, const lms3dFusedRegion& b)
{
  return a.Id == b.Id && a.Points == b.Points && a.Triangles == b.Triangles;
}
} // namespace

double lms3dGetArea(vtkPolyData* map)
{
  double area = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
  {
    map->GetPolys()->GetCellAtId(i, corners);
    area += GetArea({ corners->GetId(0), corners->GetId(1), corners->GetId(2) }, map);
  }
  return area;
}

lms3dFusedRegions lms3dTakeFusedChanges(
  vtkLMS3DMapFusion* fusion, int sinceRevision, const LMS3D::Vector3& origin, std::uint64_t number)
{
  vtkNew<vtkPolyData> delta;
  fusion->GetChanges(sinceRevision, delta);
  lms3dFusedRegions changes;
  for (const auto& [id, triangles] : SortTriangles(delta))
  {
    auto region = std::make_shared<lms3dFusedRegion>();
    region->Id = id;
    region->Changed = number;
    if (!triangles.empty())
    {
      TakeMesh(triangles, delta, origin, *region);
    }
    changes.push_back(std::move(region));
  }
  return changes;
}

void lms3dReplaceFusedRegions(
  const lms3dFusedRegions& changes, std::uint64_t number, lms3dFusedRegions& regions)
{
  lms3dFusedRegions merged;
  merged.reserve(regions.size() + changes.size());
  const auto isBefore = [](const auto& a, const auto& b) { return a->Id < b->Id; };
  lms3dFusedRegions different;
  std::copy_if(changes.begin(), changes.end(), std::back_inserter(different),
    [&](const auto& region)
    {
      const auto before = std::lower_bound(regions.begin(), regions.end(), region, isBefore);
      return before == regions.end() || !HaveSameMesh(**before, *region);
    });
  // If two regions have the same id, the first one remains.
  std::set_union(different.begin(), different.end(), regions.begin(), regions.end(),
    std::back_inserter(merged), isBefore);
  const auto isForgotten = [number](const auto& region)
  { return region->IsRemoved() && number - region->Changed > lms3dFusedMapState::Memory; };
  merged.erase(std::remove_if(merged.begin(), merged.end(), isForgotten), merged.end());
  regions = std::move(merged);
}
