// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteFusedMap.h"

#include "Client/lms3dFetchParts.h"
#include "Client/lms3dRemoteFields.h"
#include "Client/lms3dRemoteFusedMapCheck.h"
#include "Pipeline/lms3dArray.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace
{
template <typename Sequence, typename Element>
void Copy(const Sequence& part, std::vector<Element>& elements)
{
  elements.assign(part.get_buffer(), part.get_buffer() + part.length());
}

// In parts.
lms3dFusedMapChanges FetchParts(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong since, const std::function<void()>& beforePart)
{
  lms3dFusedMapChanges changes;
  beforePart();
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(since);
  lms3dCheckFusedMapHeader(header, since);
  changes.Header = header.in();
  const CORBA::ULongLong number = header->number;
  lms3dFetchParts<LMS3D::FusedRegions>(
    header->regions, 1, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getFusedRegions(number, since, first, count); },
    changes.Regions);
  lms3dFetchParts<LMS3D::Offsets>(
    header->points, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getFusedPoints(number, since, first, count); },
    changes.Points);
  lms3dFetchParts<LMS3D::Indices>(
    header->triangles, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getFusedTriangles(number, since, first, count); },
    changes.Triangles);
  return changes;
}

lms3dFusedMapChanges Fetch(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong since, const std::function<void()>& beforePart)
{
  beforePart();
  try
  {
    const LMS3D::FusedMap_var map = scanner->getFusedMap(since);
    lms3dCheckFusedMapHeader(map->header, since);
    lms3dFusedMapChanges changes;
    changes.Header = map->header;
    Copy(map->regions, changes.Regions);
    Copy(map->points, changes.Points);
    Copy(map->triangles, changes.Triangles);
    return changes;
  }
  catch (const LMS3D::LimitExceeded&)
  {
    return FetchParts(scanner, since, beforePart);
  }
  // The limit of this client's ORB is lower than the server's.
  catch (const CORBA::MARSHAL&)
  {
    return FetchParts(scanner, since, beforePart);
  }
}
} // namespace

bool lms3dRemoteFusedMap::Update(
  LMS3D::LaserScanner_ptr scanner, const std::function<void()>& beforePart)
{
  const CORBA::ULongLong since = this->Header.number;
  const lms3dFusedMapChanges changes = Fetch(scanner, since, beforePart);
  lms3dCheckFusedMapChanges(changes);
  this->Apply(changes);
  return this->Header.number != since;
}

void lms3dRemoteFusedMap::Apply(const lms3dFusedMapChanges& changes)
{
  if (changes.Header.isWhole)
  {
    this->Regions.clear();
  }
  // Before anything is copied.
  if (this->CountPointsWith(changes) > lms3dMaximumFusedPoints)
  {
    this->Refuse("the server's fused map is too large");
  }
  auto point = changes.Points.begin();
  auto corner = changes.Triangles.begin();
  for (const LMS3D::FusedRegion& region : changes.Regions)
  {
    const auto endOfPoints = point + 3 * static_cast<std::ptrdiff_t>(region.points);
    const auto endOfCorners = corner + 3 * static_cast<std::ptrdiff_t>(region.triangles);
    if (region.triangles == 0)
    {
      this->Regions.erase(region.id);
    }
    else
    {
      this->Regions[region.id] = { { point, endOfPoints }, { corner, endOfCorners } };
    }
    point = endOfPoints;
    corner = endOfCorners;
  }
  this->Header = changes.Header;
  const std::size_t triangles =
    std::accumulate(this->Regions.begin(), this->Regions.end(), std::size_t(0),
      [](std::size_t sum, const auto& region) { return sum + region.second.Triangles.size() / 3; });
  if (triangles != this->Header.allTriangles)
  {
    this->Refuse("the changes of the server's fused map do not add up to the map");
  }
}

std::size_t lms3dRemoteFusedMap::CountPointsWith(const lms3dFusedMapChanges& changes) const
{
  std::size_t points = changes.Points.size() / 3;
  for (const auto& [id, region] : this->Regions)
  {
    points += region.Points.size() / 3;
  }
  for (const LMS3D::FusedRegion& region : changes.Regions)
  {
    const auto replaced = this->Regions.find(region.id);
    points -= replaced == this->Regions.end() ? 0 : replaced->second.Points.size() / 3;
  }
  return points;
}

void lms3dRemoteFusedMap::Refuse(const char* problem)
{
  *this = {};
  throw std::runtime_error(problem);
}

std::uint64_t lms3dRemoteFusedMap::GetReceivedBytes() const
{
  const LMS3D::FusedMapHeader& header = this->Header;
  constexpr std::uint64_t BytesPerItem = 12;
  return BytesPerItem * (std::uint64_t(header.regions) + header.points + header.triangles);
}

void lms3dRemoteFusedMap::Fill(vtkPolyData* map) const
{
  this->FillTriangles(map);
  const auto scans = lms3dMakeArray<vtkIntArray>("NumberOfScans", 1);
  scans->SetValue(0, static_cast<int>(this->Header.scans));
  vtkFieldData* const fieldData = map->GetFieldData();
  lms3dAddHiddenArray(scans, fieldData);
  lms3dAddField("State", this->Header.number, fieldData);
  lms3dAddField("ScanNumber", this->Header.newestScan, fieldData);
  lms3dAddField("Incarnation", this->Header.incarnation, fieldData);
  lms3dAddField("Scene", this->Header.scene.in(), fieldData);
}

void lms3dRemoteFusedMap::FillTriangles(vtkPolyData* map) const
{
  std::size_t coordinates = 0;
  std::size_t corners = 0;
  for (const auto& [id, region] : this->Regions)
  {
    coordinates += region.Points.size();
    corners += region.Triangles.size();
  }
  const auto points = lms3dMakeArray<vtkDoubleArray>("Points", coordinates / 3, 3);
  const auto connectivity = lms3dMakeArray<vtkTypeInt32Array>("Connectivity", corners);
  const auto ids = lms3dMakeArray<vtkIntArray>("RegionId", corners / 3);
  const LMS3D::Vector3& origin = this->Header.origin;
  const std::array<double, 3> start = { origin.x, origin.y, origin.z };
  double* point = points->GetPointer(0);
  vtkTypeInt32* corner = connectivity->GetPointer(0);
  int* regionId = ids->GetPointer(0);
  vtkTypeInt32 pointsBefore = 0;
  for (const auto& [id, region] : this->Regions)
  {
    for (std::size_t i = 0; i < region.Points.size(); ++i)
    {
      *point++ = start[i % 3] + region.Points[i];
    }
    for (const std::uint32_t index : region.Triangles)
    {
      *corner++ = pointsBefore + static_cast<vtkTypeInt32>(index);
    }
    regionId = std::fill_n(regionId, region.Triangles.size() / 3, static_cast<int>(id));
    pointsBefore += static_cast<vtkTypeInt32>(region.Points.size() / 3);
  }
  lms3dSetTriangles(points, connectivity, map);
  map->GetCellData()->AddArray(ids);
}
