// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedMesher.h"

#include "LocalMap/Bounded/lms3dDeviationMeter.h"
#include "LocalMap/Bounded/lms3dFacetedGrid.h"
#include "LocalMap/Patches/lms3dPatchGrower.h"
#include "LocalMap/Patches/lms3dPatchMerger.h"
#include "LocalMap/Patches/lms3dPatchRelabeler.h"
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Patches grow tightly and merge widely, which leaves fewer of them on curved surfaces.
constexpr double GrowingShare = 0.3;
constexpr double GrowingDeviations = 4.0;
// What the planes of a crease may differ by, as a share of the bound.
constexpr double CreaseShare = 0.85;
// Standard deviations of noise, as a share of the bound, at which patches give way to the grid.
constexpr double MaximumNoise = 0.75;
// The same for the number of patches, as a share of the returns, and for scans of a few returns.
constexpr double MaximumPatches = 0.05;
constexpr double SmallScan = 256.0;
// The share of the time that finding them takes.
constexpr double PatchesDone = 0.4;

// So often single returns may leave patches, and so large a share of one, before all of it is split.
constexpr int PatientAttempts = 8;
constexpr double MaximumUncovered = 0.01;

double GetLargestRange(const lms3dRangeGrid& grid)
{
  double largest = 0.0;
  for (int turn = 0; turn < grid.GetNumberOfTurns(); ++turn)
  {
    const double* ranges = grid.GetRanges(turn);
    largest = std::max(largest, *std::max_element(ranges, ranges + grid.GetNumberOfBeams()));
  }
  return largest;
}
} // namespace

lms3dBoundedMesher::lms3dBoundedMesher(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, double maximumError)
  : Grid(grid)
  , Joins(joins)
  , MaximumError(std::min(maximumError, GetLargestRange(grid)))
  , Sphere(grid, joins)
  , Noise(lms3dEstimateNoise(this->Sphere))
{
}

lms3dPatches lms3dBoundedMesher::FindPatches() const
{
  const double tolerance =
    std::max(GrowingShare * this->MaximumError, GrowingDeviations * this->Noise);
  lms3dPatches patches = lms3dPatchGrower(this->Sphere, tolerance).Grow();
  lms3dPatchMerger(this->Sphere, patches, this->MaximumError).Merge();
  lms3dPatchRelabeler borders(this->Sphere, patches, this->MaximumError, this->Noise);
  borders.Move();
  borders.TakeSpikes();
  return patches;
}

bool lms3dBoundedMesher::AreTooMany(const std::vector<int>& members) const
{
  const std::int64_t patches =
    static_cast<std::int64_t>(members.size()) - std::count(members.begin(), members.end(), 0);
  return patches > MaximumPatches * this->Sphere.GetNumberOfReturns() + SmallScan;
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakeMap(const lms3dProgress& progress)
{
  const std::vector<lms3dVector> extremes = this->SpreadPoles();
  std::optional<lms3dBoundedMap> made = this->MakePatchMap(progress);
  if (!made)
  {
    return made;
  }
  lms3dBoundedMap& map = *made;
  for (const lms3dVector& point : extremes)
  {
    map.LargestDeviation = std::max(map.LargestDeviation, map.GetDeviation(point));
  }
  // The returns of a pole are of the kind of its first one.
  std::int64_t& kind = map.ReturnsOnPatches > 0 ? map.ReturnsOnPatches
    : map.ReturnsOnGrid > 0                     ? map.ReturnsOnGrid
                                                : map.ReturnsOnFacets;
  for (const std::vector<double>& ranges : this->Grid.GetRangesOfPoles())
  {
    kind += static_cast<std::int64_t>(ranges.size()) - (ranges.empty() ? 0 : 1);
  }
  return made;
}

// The returns of a pole are one, and the surface is made for those that the bound allows to be one with
// their median. Returns the extremes of all, which tell the largest deviation.
std::vector<lms3dVector> lms3dBoundedMesher::SpreadPoles()
{
  std::vector<lms3dVector> extremes;
  for (std::size_t i = 0; i < this->Grid.GetPoles().size(); ++i)
  {
    const std::vector<double>& ranges = this->Grid.GetRangesOfPoles()[i];
    if (ranges.empty())
    {
      continue;
    }
    const bool isLowest = this->Sphere.GetBeam(0) == this->Grid.GetPoles()[i];
    const GridIndex index = isLowest ? 0 : this->Sphere.GetNumberOfRows() - 1;
    const auto [nearest, farthest] = std::minmax_element(ranges.begin(), ranges.end());
    const std::array<double, 2> near =
      this->GetWithinBound(ranges, this->Sphere.GetRange(index), { *nearest, *farthest });
    this->Sphere.SetPole(this->Sphere.GetRow(index), near[0], near[1]);
    extremes.push_back(lms3dScale(this->Sphere.GetDirection(index), *nearest));
    if (*nearest < *farthest)
    {
      extremes.push_back(lms3dScale(this->Sphere.GetDirection(index), *farthest));
    }
  }
  return extremes;
}

// The nearest and the farthest of the returns that count: all where one vertex is within the bound of
// them, or else those around the median.
std::array<double, 2> lms3dBoundedMesher::GetWithinBound(
  const std::vector<double>& ranges, double median, const std::array<double, 2>& all) const
{
  if (all[1] - all[0] <= 2.0 * this->MaximumError)
  {
    return all;
  }
  std::array<double, 2> near = { median, median };
  for (double range : ranges)
  {
    if (std::abs(range - median) <= this->MaximumError)
    {
      near = { std::min(near[0], range), std::max(near[1], range) };
    }
  }
  return near;
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakePatchMap(const lms3dProgress& progress) const
{
  if (this->Noise > MaximumNoise * this->MaximumError)
  {
    return lms3dFacetedGrid(this->Grid, this->Joins, this->Sphere).MakeMap();
  }
  lms3dPatches patches = this->FindPatches();
  lms3dBoundedMap map;
  std::vector<int> members;
  double done = PatchesDone;
  int attempt = 0;
  do
  {
    members = patches.CountMembers(this->Sphere);
    if (this->AreTooMany(members))
    {
      return lms3dFacetedGrid(this->Grid, this->Joins, this->Sphere).MakeMap();
    }
    if (!progress(done))
    {
      return {};
    }
    // Nobody knows how many attempts there will be.
    done = 0.5 * (done + 1.0);
  } while (!this->TryToMesh(patches, members, ++attempt < PatientAttempts, map));
  this->AddFacets(patches, map);
  return map;
}

// For returns that no patch could hold.
void lms3dBoundedMesher::AddFacets(const lms3dPatches& patches, lms3dBoundedMap& map) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (patches.Labels[index] == lms3dPatches::None && this->Sphere.HasReturn(index) &&
      !this->Sphere.IsRepeated(index))
    {
      map.AddFacet(this->Sphere, index, this->Sphere.GetRange(index));
      ++map.ReturnsOnFacets;
    }
  }
}

bool lms3dBoundedMesher::TryToMesh(lms3dPatches& patches, const std::vector<int>& members,
  bool isPatient, lms3dBoundedMap& map) const
{
  const lms3dBorderGates gates(this->Sphere, patches, CreaseShare * this->MaximumError);
  const lms3dPatchOutlines outlines(this->Sphere, patches, gates);
  lms3dPatchMesher mesher(this->Sphere, patches, outlines, this->MaximumError, this->Noise);
  std::vector<lms3dPatchMesh> meshes(members.size());
  tbb::parallel_for(std::size_t(0), members.size(),
    [&](std::size_t i)
    {
      if (members[i] > 0)
      {
        meshes[i] = mesher.Mesh(static_cast<int>(i), members[i]);
      }
    });
  std::vector<bool> failed(members.size());
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    failed[i] = members[i] > 0 && !meshes[i].IsValid;
    if (!isPatient || MaximumUncovered * members[i] < static_cast<double>(meshes[i].Unmet.size()))
    {
      meshes[i].Unmet.clear();
    }
  }
  for (std::int32_t patch : outlines.GetPatchesAtFlippedStrips())
  {
    failed[patch] = true;
    meshes[patch].Unmet.clear();
  }
  if (std::find(failed.begin(), failed.end(), true) != failed.end())
  {
    this->Split(patches, members, failed, meshes);
    return false;
  }
  this->Append(patches, outlines, meshes, members, map);
  return true;
}

void lms3dBoundedMesher::Append(const lms3dPatches& patches, const lms3dPatchOutlines& outlines,
  const std::vector<lms3dPatchMesh>& meshes, const std::vector<int>& members,
  lms3dBoundedMap& map) const
{
  const auto addPoint = [&](const lms3dMapVertex& vertex)
  {
    map.Points.push_back({ vertex.Direction[0] / vertex.InverseRange,
      vertex.Direction[1] / vertex.InverseRange, vertex.Direction[2] / vertex.InverseRange });
  };
  std::for_each(outlines.GetVertices().begin(), outlines.GetVertices().end(), addPoint);
  const std::int32_t shared = static_cast<std::int32_t>(map.Points.size());
  map.Triangles = outlines.GetStripTriangles();
  map.PatchIds.assign(map.Triangles.size(), lms3dBoundedMap::NoPatch);
  std::vector<lms3dDeviationMeter::Part> parts;
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    if (members[i] == 0)
    {
      continue;
    }
    const std::int32_t offset = static_cast<std::int32_t>(map.Points.size()) - shared;
    std::for_each(meshes[i].Added.begin(), meshes[i].Added.end(), addPoint);
    const std::size_t first = map.Triangles.size();
    for (std::array<std::int32_t, 3> triangle : meshes[i].Triangles)
    {
      for (std::int32_t& corner : triangle)
      {
        corner += corner >= shared ? offset : 0;
      }
      map.Triangles.push_back(triangle);
      map.PatchIds.push_back(map.NumberOfPatches);
    }
    ++map.NumberOfPatches;
    map.ReturnsOnPatches += members[i];
    parts.push_back(
      { static_cast<std::int32_t>(i), first, map.Triangles.size(), meshes[i].DeviationOnBeams });
  }
  map.LargestDeviation = lms3dDeviationMeter(this->Sphere, patches, map).GetLargest(parts);
}

// What cannot be meshed as a whole is split into single returns, and those become facets. Where only few
// returns are beside their patch's outline, it is they that leave it.
void lms3dBoundedMesher::Split(lms3dPatches& patches, const std::vector<int>& members,
  const std::vector<bool>& failed, const std::vector<lms3dPatchMesh>& meshes) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    const std::int32_t label = patches.Labels[index];
    if (label < 0 || label >= static_cast<std::int32_t>(failed.size()) || !failed[label])
    {
      continue;
    }
    const std::vector<GridIndex>& unmet = meshes[label].Unmet;
    const GridIndex first = this->Sphere.IsRepeated(index) ? this->Sphere.GetRow(index) : index;
    if (!unmet.empty() && !std::binary_search(unmet.begin(), unmet.end(), first))
    {
      continue;
    }
    if (members[label] == 1)
    {
      patches.Labels[index] = lms3dPatches::None;
      continue;
    }
    if (this->Sphere.IsRepeated(index))
    {
      patches.Labels[index] = patches.Labels[this->Sphere.GetRow(index)];
      continue;
    }
    lms3dPatches::Patch single;
    single.Fit.Add(this->Sphere, index);
    single.Plane = single.Fit.GetPlane();
    patches.Labels[index] = static_cast<std::int32_t>(patches.Patches.size());
    patches.Patches.push_back(single);
  }
}
