// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the local map of few triangles within an error bound.
 */
#ifndef lms3dBoundedMesher_h
#define lms3dBoundedMesher_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dPatchMesher.h"
#include "Pipeline/lms3dProgress.h"

#include <array>
#include <optional>
#include <vector>

/**
 * Finds planar patches, straightens their borders and triangulates them, and returns only what has
 * been checked: every return is met by its beam on a triangle that is no farther from it than the
 * bound, measured along the beam. What fails is split into patches of one return, or loses the few
 * returns that its outline leaves out, and those that fail again become facets; where patches would
 * have fewer than twenty returns on average, or the noise is as large as the bound, the triangles of
 * the plain grid take their place.
 */
class lms3dBoundedMesher
{
public:
  /// Keeps references.
  lms3dBoundedMesher(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, double maximumError);

  /// `progress` is told the share done, 0 to 1, and returns false to stop; then there is no map.
  std::optional<lms3dBoundedMap> MakeMap(const lms3dProgress& progress);

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  lms3dPatches FindPatches() const;
  bool AreTooMany(const std::vector<int>& members) const;
  bool TryToMesh(lms3dPatches& patches, const std::vector<int>& members, bool isPatient,
    lms3dBoundedMap& map) const;
  void Append(const lms3dPatches& patches, const lms3dPatchOutlines& outlines,
    const std::vector<lms3dPatchMesh>& meshes, const std::vector<int>& members,
    lms3dBoundedMap& map) const;
  void Split(lms3dPatches& patches, const std::vector<int>& members,
    const std::vector<bool>& failed, const std::vector<lms3dPatchMesh>& meshes) const;
  std::optional<lms3dBoundedMap> MakePatchMap(const lms3dProgress& progress) const;
  void AddFacets(const lms3dPatches& patches, lms3dBoundedMap& map) const;
  std::vector<lms3dVector> SpreadPoles();
  std::array<double, 2> GetWithinBound(
    const std::vector<double>& ranges, double median, const std::array<double, 2>& all) const;

  const lms3dRangeGrid& Grid;
  const lms3dRangeJoins& Joins;
  const double MaximumError;
  lms3dBeamSphere Sphere;
  /// The standard deviation of ranges, metres.
  const double Noise;
};

#endif
