// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dGrowingMap.h"

#include "Fusion/Passages/lms3dPassedPlanes.h"
#include "Fusion/Planes/lms3dCreases.h"
#include "Fusion/Planes/lms3dPlaneTiles.h"
#include "Fusion/Planes/lms3dRegionMesher.h"
#include "Fusion/Planes/lms3dRegionSightings.h"
#include "Fusion/Returns/lms3dHandedReturns.h"
#include "Fusion/Returns/lms3dLooseRegions.h"
#include "Fusion/Returns/lms3dRegrouping.h"
#include "Fusion/Returns/lms3dScanJoin.h"
#include "Fusion/Returns/lms3dWeakPlanes.h"
#include "Fusion/Scans/lms3dLocalMap.h"
#include "Fusion/Scans/lms3dPassingBeams.h"

#include <vtkPolyData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>
#include <utility>

namespace
{
constexpr double TimeOfCasting = 0.3;
constexpr double TimeOfMarking = 0.5;
constexpr double TimeOfRenewal = 0.85;
// As a share of the time of reducing.
constexpr double TimeOfNewPlanes = 0.9;
// As a share of the time of making regions anew.
constexpr double TimeOfShapes = 0.3;
// How many tiles get new triangles between two looks at the progress.
constexpr std::size_t TilesOfStep = 64;
} // namespace

lms3dGrowingMap::lms3dGrowingMap(const lms3dFusionSettings& settings)
  : Settings(settings)
  , Planes(settings.MaximumError)
{
}

void lms3dGrowingMap::AddTable(const lms3dScanInput& scan)
{
  const auto fits = [&scan](const std::shared_ptr<const lms3dBeamTable>& table)
  { return table && scan.HasAngles(table->GetGeometry()); };
  if (!fits(this->Table))
  {
    const auto earlier = std::find_if(this->Tables.rbegin(), this->Tables.rend(), fits);
    this->Table = earlier != this->Tables.rend()
      ? *earlier
      : std::make_shared<const lms3dBeamTable>(scan.GetGeometry());
  }
}

bool lms3dGrowingMap::Add(vtkPolyData* map, vtkPolyData* scanData, const lms3dProgress& progress)
{
  const lms3dScanInput scan(scanData);
  if (map->GetNumberOfPolys() == 0)
  {
    this->Positions.push_back(lms3dFindSensorPosition(scanData));
    this->Tables.emplace_back();
    return progress(1.0);
  }
  this->AddTable(scan);
  this->Positions.push_back(scan.GetSensorPosition());
  this->Tables.push_back(this->Settings.KeepReturns ? this->Table : nullptr);
  auto ranges = std::make_unique<lms3dSeenRanges>(
    scan, this->Table, lms3dFindPassingBeams(map, scanData, this->Table->GetSize()));
  lms3dLocalMap local(map, scan, *ranges, this->Settings.MaximumError, std::move(this->Returns));
  if (!progress(TimeOfCasting))
  {
    return false;
  }
  if (this->Settings.ForgetSeenThrough)
  {
    lms3dMarkPassed(*ranges, true, this->Planes);
  }
  this->Planes.ReuseNumbers();
  this->Planes.SetScan(this->GetNumberOfScans() - 1);
  lms3dScanJoin(local, *ranges, this->Planes).Join();
  this->Returns = std::move(local.Returns);
  lms3dMarkPassed(*ranges, false, this->Planes);
  lms3dMarkPassedEarlier(this->Seen, this->Planes);
  if (this->Settings.KeepReturns)
  {
    this->Seen.push_back(std::move(ranges));
  }
  lms3dDissolveWeakPlanes(this->Planes);
  lms3dHandReturnsOver(this->Planes, this->MeshedRevision);
  this->MeshedRevision = this->GetNumberOfScans();
  if (!progress(TimeOfMarking))
  {
    return false;
  }
  return this->Renew(lms3dGetStepProgress(progress, TimeOfMarking, TimeOfRenewal)) &&
    this->Reduce(lms3dGetStepProgress(progress, TimeOfRenewal, 1.0));
}

// Lets fewer triangles take the place of others. Beams of earlier scans must say where new planes
// may have surface.
bool lms3dGrowingMap::Reduce(const lms3dProgress& progress)
{
  lms3dDropLooseRegions(this->Planes, this->LooseRevision);
  this->LooseRevision = this->GetNumberOfScans();
  if (!this->Settings.KeepReturns)
  {
    return this->Renew(progress);
  }
  lms3dRegrouping regrouping(this->Planes, this->Tables);
  if (regrouping.MakePlanes())
  {
    lms3dMarkPassedEarlier(this->Seen, this->Planes);
  }
  if (!this->Renew(lms3dGetStepProgress(progress, 0.0, TimeOfNewPlanes)))
  {
    return false;
  }
  regrouping.Choose();
  return this->Renew(lms3dGetStepProgress(progress, TimeOfNewPlanes, 1.0));
}

// The threads divide planes, then tiles. A tile depends on its plane and on other frames alone.
bool lms3dGrowingMap::Renew(const lms3dProgress& progress)
{
  std::vector<int> changed;
  for (std::size_t i = 0; i < this->Planes.GetSize(); ++i)
  {
    lms3dFusedPlane& plane = this->Planes[i];
    plane.OldBlocks = plane.Raster.GetNumberOfBlocks();
    if (plane.HasNewCreases || !plane.Raster.GetMarked().empty())
    {
      lms3dAddTiles(plane, this->Regions);
      changed.push_back(static_cast<int>(i));
    }
  }
  // The longest work comes first, so that the threads end at the same time.
  std::stable_sort(changed.begin(), changed.end(),
    [this](int a, int b) {
      return this->Planes[a].Raster.GetMarked().size() > this->Planes[b].Raster.GetMarked().size();
    });
  tbb::parallel_for(
    std::size_t{ 0 }, changed.size(), [&](std::size_t i) { this->RenewShape(changed[i]); },
    tbb::simple_partitioner());
  if (!progress(TimeOfShapes))
  {
    return false;
  }
  std::vector<TileToRenew> tiles = this->FindTiles(changed);
  std::stable_sort(tiles.begin(), tiles.end(),
    [](const TileToRenew& a, const TileToRenew& b)
    { return a.Tile->Blocks.size() > b.Tile->Blocks.size(); });
  const lms3dProgress rest = lms3dGetStepProgress(progress, TimeOfShapes, 1.0);
  for (std::size_t first = 0; first < tiles.size(); first += TilesOfStep)
  {
    const std::size_t end = std::min(first + TilesOfStep, tiles.size());
    tbb::parallel_for(
      first, end, [&](std::size_t i) { this->RenewTile(tiles[i]); }, tbb::simple_partitioner());
    if (!rest(static_cast<double>(end) / static_cast<double>(tiles.size())))
    {
      return false;
    }
  }
  return progress(1.0);
}

void lms3dGrowingMap::RenewShape(int planeNumber)
{
  lms3dFusedPlane& plane = this->Planes[planeNumber];
  std::vector<lms3dCreaseLine> creases;
  if (plane.HasNewCreases || plane.OldBlocks > plane.ShapedBlocks)
  {
    creases = lms3dGetCreaseLines(this->Planes, planeNumber);
  }
  std::set<int> tiles;
  for (const int block : plane.Shape.Update(creases, plane.Raster))
  {
    tiles.insert(plane.Raster.GetBlock(block).Tile);
  }
  for (const int tileNumber : tiles)
  {
    lms3dFusedTile& tile = plane.Tiles[tileNumber];
    tile.Difference = 0;
    tile.DifferenceAtCreases = 0;
    for (const int i : tile.Blocks)
    {
      const lms3dRasterBlock& block = plane.Raster.GetBlock(i);
      tile.Difference += block.Difference + block.NewCreaseCells;
      tile.DifferenceAtCreases += block.DifferenceAtCreases;
    }
  }
  plane.ShapedBlocks = plane.OldBlocks;
  plane.HasNewCreases = false;
}

std::vector<lms3dGrowingMap::TileToRenew> lms3dGrowingMap::FindTiles(const std::vector<int>& planes)
{
  std::vector<TileToRenew> tiles;
  for (const int number : planes)
  {
    lms3dFusedPlane& plane = this->Planes[number];
    std::shared_ptr<const std::vector<lms3dCreaseLine>> creases;
    for (const int block : plane.Raster.GetMarked())
    {
      lms3dFusedTile& tile = plane.Tiles[plane.Raster.GetBlock(block).Tile];
      tile.IsStale = tile.IsStale || plane.Raster.HasMark(block, lms3dRaster::STALE);
      tile.IsSeen = tile.IsSeen || plane.Raster.HasMark(block, lms3dRaster::SEEN);
    }
    plane.Raster.ClearMarks();
    for (lms3dFusedTile& tile : plane.Tiles)
    {
      tile.IsStale = tile.IsStale || tile.HasOtherShape();
      if (tile.IsStale && !creases)
      {
        creases = std::make_shared<const std::vector<lms3dCreaseLine>>(
          lms3dGetCreaseLines(this->Planes, number));
      }
      if (tile.IsStale || tile.IsSeen)
      {
        tiles.push_back({ number, &tile, creases });
      }
    }
  }
  return tiles;
}

void lms3dGrowingMap::RenewTile(const TileToRenew& place)
{
  lms3dFusedPlane& plane = this->Planes[place.Plane];
  lms3dFusedTile& tile = *place.Tile;
  if (tile.IsStale)
  {
    lms3dMakeTileMesh(plane, tile, *place.Creases, this->Settings.MaximumError);
    tile.Revision = this->MeshedRevision;
    tile.Difference = 0;
    tile.DifferenceAtCreases = 0;
  }
  lms3dSetSightings(plane, tile);
  tile.IsStale = false;
  tile.IsSeen = false;
}
