// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dGrowingMap.h"

#include "Fusion/lms3dCreases.h"
#include "Fusion/lms3dLocalMap.h"
#include "Fusion/lms3dPassedBeams.h"
#include "Fusion/lms3dRegionMesher.h"
#include "Fusion/lms3dRegionSightings.h"
#include "Fusion/lms3dScanJoin.h"

#include <vtkPolyData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace
{
// The share of a weak plane's returns that other planes must explain to take its place.
constexpr double DissolvedShare = 0.9;
constexpr double TimeOfCasting = 0.3;
constexpr double TimeOfMarking = 0.5;
// How many planes get new triangles between two looks at the progress.
constexpr std::size_t PlanesOfStep = 32;
} // namespace

lms3dGrowingMap::lms3dGrowingMap(const lms3dFusionSettings& settings)
  : Settings(settings)
  , Planes(settings.MaximumError)
{
}

void lms3dGrowingMap::AddTable(const lms3dScanInput& scan)
{
  if (!this->Table || !scan.HasAngles(this->Table->GetGeometry()))
  {
    this->Table = std::make_shared<lms3dBeamTable>(scan.GetGeometry());
  }
}

bool lms3dGrowingMap::Add(
  vtkPolyData* map, const lms3dScanInput& scan, const lms3dProgress& progress)
{
  if (map->GetNumberOfPolys() == 0)
  {
    this->Positions.push_back(
      scan.GetNumberOfReturns() > 0 ? scan.GetSensorPosition() : lms3dVector{ 0.0, 0.0, 0.0 });
    return progress(1.0);
  }
  this->AddTable(scan);
  this->Positions.push_back(scan.GetSensorPosition());
  auto ranges = std::make_unique<lms3dSeenRanges>(scan, this->Table);
  const lms3dLocalMap local(map, scan, *ranges, this->Settings.MaximumError);
  if (!progress(TimeOfCasting))
  {
    return false;
  }
  if (this->Settings.ForgetSeenThrough)
  {
    this->MarkPassed(*ranges, true, false);
  }
  this->Planes.SetScan(this->GetNumberOfScans() - 1);
  lms3dScanJoin(local, *ranges, this->Planes).Join();
  this->MarkPassed(*ranges, false, false);
  for (const std::unique_ptr<lms3dSeenRanges>& earlier : this->Seen)
  {
    this->MarkPassed(*earlier, false, true);
  }
  if (this->Settings.KeepReturns)
  {
    this->Seen.push_back(std::move(ranges));
  }
  this->DissolveWeakPlanes();
  if (!progress(TimeOfMarking))
  {
    return false;
  }
  return this->Renew(lms3dGetStepProgress(progress, TimeOfMarking, 1.0));
}

// A weak plane goes if other planes explain nearly all of its returns. The rest of them get facets.
void lms3dGrowingMap::DissolveWeakPlanes()
{
  const std::size_t end = this->Planes.GetSize();
  for (std::size_t i = 0; i < end; ++i)
  {
    lms3dFusedPlane& plane = this->Planes[i];
    if (!plane.IsWeak || (!plane.IsChanged && !plane.IsSeen) || plane.Returns.empty())
    {
      continue;
    }
    std::vector<int> others = this->Planes.FindPlanesNear(plane.Returns, end);
    others.erase(std::remove(others.begin(), others.end(), static_cast<int>(i)), others.end());
    if (this->Planes.CountShown(others, plane.Returns) <
      DissolvedShare * static_cast<double>(plane.Returns.size()))
    {
      continue;
    }
    std::vector<lms3dMappedReturn> returns;
    returns.swap(plane.Returns);
    plane.Raster = {};
    plane.Verbatim.clear();
    plane.OldBlocks = 0;
    plane.IsWeak = false;
    plane.IsChanged = true;
    for (const lms3dMappedReturn& mapped : returns)
    {
      if (!this->Planes.AddToPlanes(others, mapped))
      {
        this->Planes.AddFacet(mapped);
      }
    }
  }
}

// The threads divide the planes. A plane depends on the frames of other planes alone.
bool lms3dGrowingMap::Renew(const lms3dProgress& progress)
{
  std::vector<int> changed;
  for (std::size_t i = 0; i < this->Planes.GetSize(); ++i)
  {
    lms3dFusedPlane& plane = this->Planes[i];
    plane.OldBlocks = plane.Raster.GetNumberOfBlocks();
    if (plane.IsChanged || plane.IsSeen)
    {
      changed.push_back(static_cast<int>(i));
    }
  }
  // The threads share the work best if large planes come first.
  std::stable_sort(changed.begin(), changed.end(),
    [&](int a, int b)
    {
      return this->Planes[a].Raster.GetNumberOfBlocks() >
        this->Planes[b].Raster.GetNumberOfBlocks();
    });
  const std::size_t count = changed.size();
  for (std::size_t first = 0; first < count; first += PlanesOfStep)
  {
    const std::size_t end = std::min(first + PlanesOfStep, count);
    tbb::parallel_for(
      first, end, [&](std::size_t i) { this->RenewPlane(changed[i]); }, tbb::simple_partitioner());
    if (!progress(static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

void lms3dGrowingMap::RenewPlane(int number)
{
  lms3dFusedPlane& plane = this->Planes[number];
  if (plane.IsChanged)
  {
    lms3dMakeRegionMesh(
      plane, lms3dGetCreaseLines(this->Planes, number), this->Settings.MaximumError);
    plane.Revision = this->GetNumberOfScans();
  }
  lms3dSetSightings(plane);
  plane.IsChanged = false;
  plane.IsSeen = false;
}

void lms3dGrowingMap::MarkPassed(const lms3dSeenRanges& ranges, bool forgets, bool newBlocksOnly)
{
  tbb::parallel_for(std::size_t{ 0 }, this->Planes.GetSize(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = this->Planes[i];
      const int first = newBlocksOnly ? plane.OldBlocks : 0;
      if (first < plane.Raster.GetNumberOfBlocks())
      {
        lms3dPassedBeams(ranges, this->Settings.MaximumError, forgets).Mark(plane, first);
      }
    });
}
