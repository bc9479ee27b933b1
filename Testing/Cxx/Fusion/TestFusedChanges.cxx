// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plays clients that fetch what changed after every scan, or after some.
 */
#include "Fusion/FusionFixtures.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace
{
/// The corners of each triangle of a region, sorted.
using Triangles = std::vector<std::array<Point, 3>>;
using Regions = std::map<int, Triangles>;

Regions GetRegions(vtkPolyData* map)
{
  Regions regions;
  vtkDataArray* const ids = map->GetCellData()->GetArray("RegionId");
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
  {
    map->GetPolys()->GetCellAtId(i, corners);
    std::array<Point, 3> triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      map->GetPoint(corners->GetId(corner), triangle[corner].data());
    }
    regions[static_cast<int>(ids->GetTuple1(i))].push_back(triangle);
  }
  for (auto& [region, triangles] : regions)
  {
    std::sort(triangles.begin(), triangles.end());
  }
  return regions;
}

/// Keeps a map up to date as the header of the filter says.
class Client
{
public:
  /// Fetches what changed if the number of scans is a multiple of the interval.
  void Fetch(vtkLMS3DMapFusion* fusion, int interval)
  {
    if (fusion->GetNumberOfScans() % interval != 0)
    {
      return;
    }
    vtkNew<vtkPolyData> delta;
    fusion->GetChanges(this->Revision, delta);
    this->Revision = fusion->GetRevision();
    vtkDataArray* const changed = delta->GetFieldData()->GetArray("ChangedRegions");
    for (vtkIdType i = 0; i < changed->GetNumberOfTuples(); ++i)
    {
      this->Known.erase(static_cast<int>(changed->GetTuple1(i)));
    }
    for (const auto& [region, triangles] : GetRegions(delta))
    {
      EXPECT_EQ(this->Known.count(region), 0U) << "the region is not among the changed ones";
      this->Known[region] = triangles;
    }
    EXPECT_TRUE(this->Known == GetRegions(fusion->GetOutput())) << interval;
  }

private:
  int Revision = 0;
  Regions Known;
};
} // namespace

TEST(LMS3DFusedChanges, GiveClientsTheMap)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  std::array<Client, 3> clients;
  constexpr std::array<int, 3> Intervals = { 1, 2, 5 };
  std::set<int> filled;
  std::set<int> emptied;
  int filledAgain = 0;
  for (const MappedScan& scan : ScanRoomAnywhere(10))
  {
    ASSERT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
    fusion->Update();
    const Regions regions = GetRegions(fusion->GetOutput());
    for (const int region : filled)
    {
      if (regions.count(region) == 0)
      {
        emptied.insert(region);
      }
    }
    for (const auto& [region, triangles] : regions)
    {
      filled.insert(region);
      filledAgain += emptied.erase(region) > 0 ? 1 : 0;
    }
    for (std::size_t i = 0; i < clients.size(); ++i)
    {
      clients[i].Fetch(fusion, Intervals[i]);
    }
  }
  EXPECT_GT(filledAgain, 0);
}
