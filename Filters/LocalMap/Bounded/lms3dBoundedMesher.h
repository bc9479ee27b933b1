// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the local map: few triangles within an error bound.
 */
#ifndef lms3dBoundedMesher_h
#define lms3dBoundedMesher_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Gaps/lms3dSurfaceGaps.h"
#include "LocalMap/Patches/lms3dPatches.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <optional>
#include <vector>

/**
 * Finds planar patches (LocalMap/Patches), straightens their borders (LocalMap/Borders), and
 * triangulates them. The map contains only what has been checked: each beam with a return hits a
 * triangle, and the hit is within the bound of the return along the beam.
 *
 * What fails the check falls back step by step: to patches that give up a few returns, to quarters
 * of patches, to the patch of a neighbour, to a facet for each return. At last, lms3dMapSimplifier
 * removes vertices. The plain grid and facets (lms3dFacetedGrid) take the place of all patches if
 * patches would have fewer than twenty returns on average, or if the noise of the ranges exceeds
 * three quarters of the bound. If beams are not regular, only the returns beside a fault leave
 * their patch (lms3dPatchSplitter).
 *
 * Filled beams (lms3dRangeGrid) belong to patches, but to nothing else: if a filled beam loses its
 * patch, the beam has no range any more.
 */
class lms3dBoundedMesher
{
public:
  /// Keeps references to the grid, which must have at least one return, and to its joins.
  /// `maximumError` is the bound, metres, above 0. Without a `geometry`, beams are regular. Throws
  /// std::runtime_error as lms3dBeamSphere does. Uses the threads of the calling TBB arena.
  lms3dBoundedMesher(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, double maximumError,
    const lms3dMapGeometry* geometry = nullptr);

  /// Makes the map. To be called once. There is none if `progress` returned false, or if
  /// NeedsUnfilledGrid(). Uses the threads of the calling TBB arena.
  std::optional<lms3dBoundedMap> MakeMap(const lms3dProgress& progress);

  /// Whether the map must be the plain grid, but the grid has filled beams.
  bool NeedsUnfilledGrid() const { return this->IsFilledInVain; }

  /// Adds a facet for each of these returns to a map that MakeMap() made.
  void AddSpeckles(const std::vector<lms3dGapBeam>& beams, lms3dBoundedMap& map) const;

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  std::optional<lms3dBoundedMap> MakePatchMap(const lms3dProgress& progress);
  std::optional<lms3dBoundedMap> MakePlainGrid();
  lms3dPatches FindPatches() const;
  std::vector<int> RemoveFilled(lms3dPatches& patches);
  std::vector<int> CollectFilled() const;
  /// Whether neighbours are near enough that vertices may move.
  bool IsFine() const;
  bool AreTooMany(const std::vector<int>& members) const;
  void AddFacets(const lms3dPatches& patches, lms3dBoundedMap& map) const;
  void AddReturnsBeyondAxis(lms3dBoundedMap& map) const;

  const lms3dRangeGrid& Grid;
  const lms3dRangeJoins& Joins;
  /// Metres, at most the largest range.
  const double MaximumError;
  lms3dBeamSphere Sphere;
  /// The standard deviation of ranges, metres.
  const double Noise;
  /// The bound that patches keep, metres: MaximumError or less.
  const double PatchError;
  bool IsFilledInVain = false;
};

#endif
