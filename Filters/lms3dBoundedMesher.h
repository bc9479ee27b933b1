// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the local map of few triangles within an error bound.
 */
#ifndef lms3dBoundedMesher_h
#define lms3dBoundedMesher_h

#include "lms3dBoundedMap.h"
#include "lms3dPatchMesher.h"

#include <cstdint>
#include <vector>

/**
 * Finds planar patches, straightens their borders and triangulates them, and returns only what has
 * been checked: every return is met by its beam on a triangle that is no farther from it than the
 * bound, measured along the beam. What fails is split into patches of one return, and those that
 * fail again become facets; where there would be nearly as many patches as returns, or the noise is
 * as large as the bound, the triangles of the plain grid take their place.
 */
class lms3dBoundedMesher
{
public:
  /// Keeps references.
  lms3dBoundedMesher(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, double maximumError);

  /// `ranges` and `beamIds` belong to the `count` returns that the grid holds.
  lms3dBoundedMap MakeMap(const double* ranges, const int* beamIds, std::int64_t count);

private:
  using Place = lms3dBeamSphere::Place;

  double EstimateNoise() const;
  lms3dPatches FindPatches(double noise) const;
  bool AreTooMany(const std::vector<int>& members) const;
  bool TryToMesh(
    lms3dPatches& patches, const std::vector<int>& members, lms3dBoundedMap& map) const;
  void Append(const lms3dPatchOutlines& outlines, const std::vector<lms3dPatchMesh>& meshes,
    const std::vector<int>& members, lms3dBoundedMap& map) const;
  void Split(
    lms3dPatches& patches, const std::vector<int>& members, const std::vector<bool>& failed) const;
  lms3dBoundedMap MakePatchMap() const;
  lms3dBoundedMap MakeGridMap() const;
  void SpreadPole(int beam, const double* ranges, const int* beamIds, std::int64_t count,
    std::vector<lms3dVector>& extremes);

  const lms3dRangeGrid& Grid;
  const lms3dRangeJoins& Joins;
  const double MaximumError;
  lms3dBeamSphere Sphere;
};

#endif
