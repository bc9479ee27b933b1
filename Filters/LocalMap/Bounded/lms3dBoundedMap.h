// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The local map within an error bound, in the sensor frame.
 */
#ifndef lms3dBoundedMap_h
#define lms3dBoundedMap_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <array>
#include <cstdint>
#include <vector>

struct lms3dBoundedMap
{
  /// The patch of triangles that join patches along an offset, and of the triangles of the plain
  /// grid.
  static constexpr std::int32_t NoPatch = -1;

  /// In the sensor frame, metres.
  std::vector<lms3dVector> Points;
  /// Numbers of points, counter-clockwise as the sensor sees them.
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// One patch for each triangle, 0 to NumberOfPatches - 1, or NoPatch.
  std::vector<std::int32_t> PatchIds;

  std::int32_t NumberOfPatches = 0;
  ///@{
  /// How many returns each kind of triangle represents. All returns of a pole count.
  std::int64_t ReturnsOnPatches = 0;
  std::int64_t ReturnsOnGrid = 0;
  std::int64_t ReturnsOnFacets = 0;
  std::int64_t ReturnsOnSpeckles = 0;
  ///@}
  /// The filled beams (lms3dRangeGrid) behind which the surface goes on: turn * number of beams +
  /// beam, sorted.
  std::vector<int> FilledBeams;
  /// The largest distance, metres, from a return to the triangle that its beam hits.
  double LargestDeviation = 0.0;

  /**
   * Adds a facet: a small triangle around the point of a beam at `range` metres. It faces the
   * sensor, is too small to be hit by any other beam, and is a patch of its own.
   */
  void AddFacet(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range);

  /// The same at a range along the beam from where it starts.
  void AddFacetOnBeam(
    const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range);

  /// The same around a point that is not the origin. `angle`, radians, is that to the nearest
  /// neighbour as the sensor sees it.
  void AddFacet(const lms3dVector& point, double angle);

  /// The distance, metres, from a point to the nearest triangle that the beam through the point
  /// hits; infinite if it hits none. Looks at all triangles.
  double GetDeviation(const lms3dVector& point) const;

  /// The triangles that a beam hits.
  lms3dBoundedMap GetPart(const lms3dVector& direction) const;

  /// Whether the sensor sees a triangle's corners counter-clockwise.
  bool IsFacing(const std::array<std::int32_t, 3>& triangle) const;

  /// Adds a facet. `direction` and `right` have length 1 and a right angle between them.
  void AddFacet(const lms3dVector& direction, const lms3dVector& right, double range, double angle);

  /// Whether the beam through a point hits a triangle.
  bool IsHit(const std::array<std::int32_t, 3>& triangle, const lms3dVector& point) const;

  /// Removes the points that belong to no triangle and renumbers the others.
  void RemoveUnusedPoints();

  /// Renumbers the patches without gaps. A patch without triangles loses its number.
  void RemoveUnusedPatches();
};

#endif
