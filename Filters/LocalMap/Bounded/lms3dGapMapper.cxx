// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dGapMapper.h"

#include "LocalMap/Bounded/lms3dBoundedMesher.h"
#include "LocalMap/Grid/lms3dMapScan.h"
#include "Pipeline/lms3dArray.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace
{
// The share of the time that finding the joins of neighbours takes.
constexpr double JoinsDone = 0.1;

template <typename ArrayT, typename T>
void AddField(const char* name, const std::vector<T>& values, vtkPolyData* map)
{
  const auto array = lms3dMakeArray<ArrayT>(name, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  lms3dAddHiddenArray(array, map->GetFieldData());
}

// The BeamIds of beams, sorted.
std::vector<int> GetBeamIds(const std::vector<lms3dGapBeam>& beams)
{
  std::vector<int> ids;
  ids.reserve(beams.size());
  for (const lms3dGapBeam& beam : beams)
  {
    ids.push_back(beam.BeamId);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

// The beams of a group follow each other.
vtkIdType CountGroups(const std::vector<lms3dGapBeam>& beams)
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < beams.size(); ++i)
  {
    count += i == 0 || beams[i].Group != beams[i - 1].Group ? 1 : 0;
  }
  return count;
}
} // namespace

lms3dGapMapper::lms3dGapMapper(const lms3dMapScan& scan, lms3dRangeGrid& grid,
  lms3dRangeJoins& joins, const lms3dGapSettings& settings, bool keepsSpeckles,
  const std::vector<bool>& isFree)
  : Scan(scan)
  , Grid(grid)
  , Joins(joins)
  , Settings(settings)
  , KeepsSpeckles(keepsSpeckles)
  , IsFree(isFree)
{
}

std::optional<lms3dBoundedMap> lms3dGapMapper::MakeMap(const lms3dProgress& progress)
{
  const lms3dMapGeometry& geometry = this->Scan.GetGeometry();
  const bool hasSpeckles = this->Settings.MaximumSpeckleSize > 0;
  if (hasSpeckles)
  {
    this->Joins.Find(this->Grid, this->Settings.DepthStep, &geometry);
  }
  if (hasSpeckles || this->Settings.MaximumGapSize > 0)
  {
    const lms3dSurfaceGaps gaps(this->Grid, this->Joins, geometry, this->Settings, this->IsFree);
    this->GapBeams = gaps.GetGapBeams();
    this->SpeckleBeams = gaps.GetSpeckleBeams();
    this->Grid.Fill(gaps.GetFilledBeams());
  }
  if (!hasSpeckles || this->Grid.HasFilledBeams())
  {
    this->Joins.Find(this->Grid, this->Settings.DepthStep, &geometry);
  }
  if (!progress(JoinsDone))
  {
    return {};
  }
  const auto progressOfRest = [&progress](double done)
  { return progress(JoinsDone + done * (1.0 - JoinsDone)); };
  lms3dBoundedMesher mesher(this->Grid, this->Joins, this->Settings.MaximumError, &geometry);
  std::optional<lms3dBoundedMap> map = mesher.MakeMap(progressOfRest);
  if (mesher.NeedsUnfilledGrid())
  {
    return this->MakeMapWithoutGaps(progress);
  }
  if (map)
  {
    map->ReturnsOnSpeckles = static_cast<std::int64_t>(this->SpeckleBeams.size());
    if (this->KeepsSpeckles)
    {
      mesher.AddSpeckles(this->SpeckleBeams, *map);
    }
  }
  return map;
}

std::optional<lms3dBoundedMap> lms3dGapMapper::MakeMapWithoutGaps(const lms3dProgress& progress)
{
  this->LeaveSpecklesOut();
  this->Joins.Find(this->Grid, this->Settings.DepthStep, &this->Scan.GetGeometry());
  lms3dBoundedMesher mesher(
    this->Grid, this->Joins, this->Settings.MaximumError, &this->Scan.GetGeometry());
  // The time that is left is unknown.
  std::optional<lms3dBoundedMap> map =
    mesher.MakeMap([&progress](double) { return progress(1.0); });
  this->GapBeams.clear();
  if (map)
  {
    map->ReturnsOnSpeckles = static_cast<std::int64_t>(this->SpeckleBeams.size());
  }
  return map;
}

// Builds the grid again. It has the returns of speckles if these are kept; then they are no
// speckles any more.
void lms3dGapMapper::LeaveSpecklesOut()
{
  const lms3dScanGeometry& geometry = this->Scan.GetGeometry().GetGrid();
  if (this->KeepsSpeckles)
  {
    this->SpeckleBeams.clear();
  }
  std::vector<bool> isSpeckle(geometry.CountBeamsOfAllTurns(), false);
  for (const lms3dGapBeam& beam : this->SpeckleBeams)
  {
    isSpeckle[static_cast<std::size_t>(beam.Turn) * geometry.GetNumberOfBeams() + beam.Beam] = true;
  }
  std::vector<double> ranges;
  std::vector<int> beamIds;
  for (std::int64_t i = 0; i < this->Scan.GetNumberOfReturns(); ++i)
  {
    const int beamId = this->Scan.GetBeamIds()[i];
    if (!isSpeckle[beamId])
    {
      ranges.push_back(this->Scan.GetRanges()[i]);
      beamIds.push_back(beamId);
    }
  }
  this->Grid.Build(
    geometry, ranges.data(), beamIds.data(), static_cast<std::int64_t>(ranges.size()));
}

void lms3dGapMapper::FillOutput(const lms3dBoundedMap& bounded, vtkPolyData* map) const
{
  if (this->Settings.MaximumGapSize > 0)
  {
    this->FillGaps(bounded, map);
  }
  if (this->Settings.MaximumSpeckleSize > 0)
  {
    AddField<vtkIdTypeArray>(
      "NumberOfReturnsOnSpeckles", std::vector<vtkIdType>{ bounded.ReturnsOnSpeckles }, map);
    this->FillSpeckles(map);
  }
}

// A beam that lost its patch is open.
void lms3dGapMapper::FillGaps(const lms3dBoundedMap& bounded, vtkPolyData* map) const
{
  std::vector<bool> isFilled(
    static_cast<std::size_t>(this->Grid.GetNumberOfTurns()) * this->Grid.GetNumberOfBeams(), false);
  for (int place : bounded.FilledBeams)
  {
    isFilled[place] = true;
  }
  std::vector<lms3dGapBeam> closed;
  double area = 0.0;
  for (const lms3dGapBeam& beam : this->GapBeams)
  {
    if (isFilled[static_cast<std::size_t>(beam.Turn) * this->Grid.GetNumberOfBeams() + beam.Beam])
    {
      closed.push_back(beam);
      area += beam.Area;
    }
  }
  AddField<vtkIdTypeArray>(
    "NumberOfClosedGaps", std::vector<vtkIdType>{ CountGroups(closed) }, map);
  AddField<vtkDoubleArray>("ClosedGapArea", std::vector<double>{ area }, map);
  AddField<vtkIntArray>("ClosedBeamIds", GetBeamIds(closed), map);
}

void lms3dGapMapper::FillSpeckles(vtkPolyData* map) const
{
  AddField<vtkIdTypeArray>(
    "NumberOfSpeckles", std::vector<vtkIdType>{ CountGroups(this->SpeckleBeams) }, map);
  AddField<vtkIntArray>("SpeckleBeamIds", GetBeamIds(this->SpeckleBeams), map);
}
