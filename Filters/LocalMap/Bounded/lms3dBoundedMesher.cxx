// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBoundedMesher.h"

#include "LocalMap/Bounded/lms3dDeviationMeter.h"
#include "LocalMap/Bounded/lms3dFacetedGrid.h"
#include "LocalMap/Bounded/lms3dMapSimplifier.h"
#include "LocalMap/Bounded/lms3dPatchSetMesher.h"
#include "LocalMap/Bounded/lms3dPoleRanges.h"
#include "LocalMap/Patches/lms3dPatchGrower.h"
#include "LocalMap/Patches/lms3dPatchMerger.h"
#include "LocalMap/Patches/lms3dPatchRelabeler.h"
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace
{
// Patches grow with a smaller tolerance than they merge with, which leaves fewer of them on curved
// surfaces: this share of the bound, or this number of standard deviations of the noise.
constexpr double GrowingShare = 0.3;
constexpr double GrowingDeviations = 4.0;
// The largest bound of patches: a share of the mean range, but at least this number of standard
// deviations of the noise. Above, planes would cut the corners of a room, and the patches would
// fail the proof.
constexpr double MaximumShareOfRange = 0.1;
constexpr double PatchDeviations = 8.0;
// More than a few operations round.
constexpr double Rounding = 1.0 + 1e-12;
// The standard deviation of the noise, as a share of the bound, above which the plain grid is made.
constexpr double MaximumNoise = 0.75;
// The number of patches above which the plain grid is made: a share of the returns, and a number
// that scans of few returns may have. Up to that share, the map of hills has at most nine tenths of
// the plain grid's triangles.
constexpr double MaximumPatchShare = 0.2;
constexpr double SmallScan = 256.0;
// The share of the time that finding patches takes.
constexpr double PatchesDone = 0.4;
// Larger cells leave too much open between their beams for vertices to move. Square degrees between
// four neighbours: about 5000 beams all around. (The shape of the cell does not count.)
constexpr double LargestCellToSimplify = 13.0;
// The number of attempts in which patches may give up a few returns instead of being split.
constexpr int ReleasingAttempts = 8;
// The same if beams are not regular: faults have more causes there.
constexpr int ReleasingAttemptsOnRays = 16;

// A share of the mean range, or `length` if it is smaller.
double LimitToShareOfMeanRange(const lms3dBeamSphere& sphere, double share, double length)
{
  double sum = 0.0;
  std::int64_t count = 0;
  // A part of the returns is often enough: the mean of all is at least their sum by the number of
  // all entries.
  const double enough = length / share * sphere.GetSize() * Rounding;
  for (lms3dBeamSphere::GridIndex index = 0; index < sphere.GetSize(); ++index)
  {
    if (sphere.HasReturn(index))
    {
      sum += sphere.GetRange(index);
      ++count;
      if (sum > enough)
      {
        return length;
      }
    }
  }
  return std::min(length, count > 0 ? share * (sum / static_cast<double>(count)) : 0.0);
}

} // namespace

lms3dBoundedMesher::lms3dBoundedMesher(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
  double maximumError, const lms3dMapGeometry* geometry)
  : Grid(grid)
  , Joins(joins)
  , MaximumError(grid.LimitToLargestRange(maximumError))
  , Sphere(grid, joins, geometry)
  , Noise(lms3dEstimateNoise(this->Sphere))
  , PatchError(
      std::max(LimitToShareOfMeanRange(this->Sphere, MaximumShareOfRange, this->MaximumError),
        std::min(this->MaximumError, PatchDeviations * this->Noise)))
{
}

lms3dPatches lms3dBoundedMesher::FindPatches() const
{
  const double tolerance =
    std::max(GrowingShare * this->PatchError, GrowingDeviations * this->Noise);
  lms3dPatches patches = lms3dPatchGrower(this->Sphere, tolerance).Grow();
  lms3dPatchMerger(this->Sphere, patches, this->PatchError).Merge();
  lms3dPatchRelabeler relabeler(this->Sphere, patches, this->PatchError, this->Noise);
  relabeler.RelabelBorders();
  relabeler.AbsorbSpikes();
  return patches;
}

bool lms3dBoundedMesher::IsFine() const
{
  const lms3dScanGeometry& geometry = this->Grid.GetGeometry();
  return std::abs(geometry.GetAlphaStep() * geometry.GetBetaStep()) <= LargestCellToSimplify;
}

bool lms3dBoundedMesher::AreTooMany(const std::vector<int>& members) const
{
  const std::int64_t patches =
    static_cast<std::int64_t>(members.size()) - std::count(members.begin(), members.end(), 0);
  return patches > MaximumPatchShare * this->Sphere.GetNumberOfReturns() + SmallScan;
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakeMap(const lms3dProgress& progress)
{
  const lms3dPoleRanges poles(this->Grid, this->MaximumError, this->Sphere);
  std::optional<lms3dBoundedMap> map = this->MakePatchMap(progress);
  if (map)
  {
    poles.AddTo(*map);
    this->AddReturnsBeyondAxis(*map);
  }
  return map;
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakePlainGrid()
{
  this->IsFilledInVain = this->Grid.HasFilledBeams();
  return this->IsFilledInVain
    ? std::nullopt
    : std::optional(lms3dFacetedGrid(this->Grid, this->Joins, this->Sphere).MakeMap());
}

std::optional<lms3dBoundedMap> lms3dBoundedMesher::MakePatchMap(const lms3dProgress& progress)
{
  if (this->Noise > MaximumNoise * this->MaximumError)
  {
    return this->MakePlainGrid();
  }
  lms3dPatches patches = this->FindPatches();
  lms3dPatchSetMesher mesher(this->Sphere, this->PatchError, this->Noise);
  lms3dBoundedMap map;
  std::vector<int> members;
  double done = PatchesDone;
  const int attempts = this->Sphere.IsRegular() ? ReleasingAttempts : ReleasingAttemptsOnRays;
  int attempt = 0;
  do
  {
    members = this->RemoveFilled(patches);
    if (this->AreTooMany(members))
    {
      return this->MakePlainGrid();
    }
    if (!progress(done))
    {
      return {};
    }
    // The number of attempts is unknown.
    done = 0.5 * (done + 1.0);
  } while (!mesher.TryToMesh(patches, members, ++attempt < attempts, map));
  const bool isSimplified = this->IsFine() &&
    lms3dMapSimplifier(this->Sphere, patches, this->MaximumError, this->Noise)
      .Simplify(members, map);
  if (this->Sphere.IsRegular() && !isSimplified)
  {
    map.LargestDeviation =
      lms3dDeviationMeter(this->Sphere, patches, map).GetLargest(this->MaximumError);
  }
  if (map.ReturnsOnPatches < this->Sphere.GetNumberOfReturns())
  {
    this->AddFacets(patches, map);
  }
  map.FilledBeams = this->CollectFilled();
  return map;
}

// Removes the filled entries that lost their patches or that make up a patch alone. Returns how
// many members each patch has.
std::vector<int> lms3dBoundedMesher::RemoveFilled(lms3dPatches& patches)
{
  const std::vector<int> members = patches.CountMembers(this->Sphere);
  const std::uint8_t* const filled = this->Sphere.GetFilled();
  for (GridIndex index = 0; this->Sphere.HasFilled() && index < this->Sphere.GetSize(); ++index)
  {
    std::int32_t& label = patches.Labels[index];
    if (filled[index] != 0 && (label < 0 || members[label] == 0))
    {
      label = lms3dPatches::None;
      this->Sphere.Remove(index);
    }
  }
  return members;
}

std::vector<int> lms3dBoundedMesher::CollectFilled() const
{
  std::vector<int> places;
  const std::uint8_t* const filled = this->Sphere.GetFilled();
  for (GridIndex index = 0; this->Sphere.HasFilled() && index < this->Sphere.GetSize(); ++index)
  {
    if (filled[index] != 0)
    {
      places.push_back(
        this->Sphere.GetTurn(index) * this->Grid.GetNumberOfBeams() + this->Sphere.GetBeam(index));
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}
