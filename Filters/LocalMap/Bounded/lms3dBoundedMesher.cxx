// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedMesher.h"

#include "LocalMap/Bounded/lms3dFacetedGrid.h"
#include "LocalMap/Bounded/lms3dPatchSetMesher.h"
#include "LocalMap/Bounded/lms3dPoleRanges.h"
#include "LocalMap/Patches/lms3dPatchGrower.h"
#include "LocalMap/Patches/lms3dPatchMerger.h"
#include "LocalMap/Patches/lms3dPatchRelabeler.h"
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace
{
// Patches grow with a smaller tolerance than they merge with, which leaves fewer of them on curved
// surfaces: this share of the bound, or this number of standard deviations of the noise.
constexpr double GrowingShare = 0.3;
constexpr double GrowingDeviations = 4.0;
// The standard deviation of the noise, as a share of the bound, above which the plain grid is made.
constexpr double MaximumNoise = 0.75;
// The number of patches above which the plain grid is made: a share of the returns, and a number that
// scans of few returns may have.
constexpr double MaximumPatchShare = 0.05;
constexpr double SmallScan = 256.0;
// The share of the time that finding patches takes.
constexpr double PatchesDone = 0.4;
// The number of attempts in which patches may give up a few returns instead of being split.
constexpr int ReleasingAttempts = 8;
// The same if beams are not regular: faults have more causes there.
constexpr int ReleasingAttemptsOnRays = 16;
// The size of a facet beyond the axis, where neighbours are close together: as if a neighbour were that far
// away, radians.
constexpr double AngleBeyondAxis = 1e-3;

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

lms3dBoundedMesher::lms3dBoundedMesher(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
  double maximumError, const lms3dMapGeometry* geometry)
  : Grid(grid)
  , Joins(joins)
  , MaximumError(std::min(maximumError, GetLargestRange(grid)))
  , Sphere(grid, joins, geometry)
  , Noise(lms3dEstimateNoise(this->Sphere))
{
}

lms3dPatches lms3dBoundedMesher::FindPatches() const
{
  const double tolerance =
    std::max(GrowingShare * this->MaximumError, GrowingDeviations * this->Noise);
  lms3dPatches patches = lms3dPatchGrower(this->Sphere, tolerance).Grow();
  lms3dPatchMerger(this->Sphere, patches, this->MaximumError).Merge();
  lms3dPatchRelabeler relabeler(this->Sphere, patches, this->MaximumError, this->Noise);
  relabeler.RelabelBorders();
  relabeler.AbsorbSpikes();
  return patches;
}

bool lms3dBoundedMesher::AreTooMany(const std::vector<int>& members) const
{
  const std::int64_t patches =
    static_cast<std::int64_t>(members.size()) - std::count(members.begin(), members.end(), 0);
  return patches > MaximumPatchShare * this->Sphere.GetNumberOfReturns() + SmallScan;
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakeMap(const lms3dProgress& progress)
{
  const std::vector<lms3dVector> extremes =
    lms3dSetPoleRanges(this->Grid, this->MaximumError, this->Sphere);
  std::optional<lms3dBoundedMap> map = this->MakePatchMap(progress);
  if (map)
  {
    for (const lms3dVector& point : extremes)
    {
      map->LargestDeviation = std::max(map->LargestDeviation, map->GetDeviation(point));
    }
    this->CountPoles(*map);
    this->AddReturnsBeyondAxis(*map);
  }
  return map;
}

// Counts all returns of a pole like the first one, which a patch, the grid or a facet represents.
void lms3dBoundedMesher::CountPoles(lms3dBoundedMap& map) const
{
  std::int64_t& count = map.ReturnsOnPatches > 0 ? map.ReturnsOnPatches
    : map.ReturnsOnGrid > 0                      ? map.ReturnsOnGrid
                                                 : map.ReturnsOnFacets;
  for (const std::vector<double>& ranges : this->Grid.GetRangesOfPoles())
  {
    count += static_cast<std::int64_t>(ranges.size()) - (ranges.empty() ? 0 : 1);
  }
}

// Adds a facet for each return beyond the axis, unless it lies within the bound of a patch.
void lms3dBoundedMesher::AddReturnsBeyondAxis(lms3dBoundedMap& map) const
{
  const std::vector<lms3dVector>& points = this->Sphere.GetPointsBeyondAxis();
  std::vector<double> deviations(points.size(), std::numeric_limits<double>::infinity());
  if (map.ReturnsOnPatches > 0)
  {
    tbb::parallel_for(std::size_t(0), points.size(),
      [&](std::size_t i) { deviations[i] = map.GetDeviation(points[i]); });
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (deviations[i] <= this->MaximumError)
    {
      map.LargestDeviation = std::max(map.LargestDeviation, deviations[i]);
      ++map.ReturnsOnPatches;
      continue;
    }
    map.AddFacet(points[i], AngleBeyondAxis);
    ++map.ReturnsOnFacets;
  }
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakePatchMap(const lms3dProgress& progress) const
{
  if (this->Noise > MaximumNoise * this->MaximumError)
  {
    return lms3dFacetedGrid(this->Grid, this->Joins, this->Sphere).MakeMap();
  }
  lms3dPatches patches = this->FindPatches();
  const lms3dPatchSetMesher mesher(this->Sphere, this->MaximumError, this->Noise);
  lms3dBoundedMap map;
  std::vector<int> members;
  double done = PatchesDone;
  const int attempts = this->Sphere.IsRegular() ? ReleasingAttempts : ReleasingAttemptsOnRays;
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
    // The number of attempts is unknown.
    done = 0.5 * (done + 1.0);
  } while (!mesher.TryToMesh(patches, members, ++attempt < attempts, map));
  this->AddFacets(patches, map);
  return map;
}

// Adds a facet for each return that left its patch.
void lms3dBoundedMesher::AddFacets(const lms3dPatches& patches, lms3dBoundedMap& map) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (patches.Labels[index] == lms3dPatches::None && this->Sphere.HasReturn(index) &&
      !this->Sphere.IsPoleCopy(index))
    {
      map.AddFacet(this->Sphere, index, this->Sphere.GetRange(index));
      ++map.ReturnsOnFacets;
    }
  }
}
