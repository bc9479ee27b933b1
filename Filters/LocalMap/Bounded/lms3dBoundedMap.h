// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A local map within an error bound, in the sensor frame.
 */
#ifndef lms3dBoundedMap_h
#define lms3dBoundedMap_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <array>
#include <cstdint>
#include <vector>

struct lms3dBoundedMap
{
  /// In place of a patch: triangles that join patches across a step, and those of the plain grid.
  static constexpr std::int32_t NoPatch = -1;

  std::vector<lms3dVector> Points;
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// Of each triangle.
  std::vector<std::int32_t> PatchIds;

  std::int32_t NumberOfPatches = 0;
  std::int64_t ReturnsOnPatches = 0;
  std::int64_t ReturnsOnGrid = 0;
  std::int64_t ReturnsOnFacets = 0;
  /// The largest distance, metres, of a return to the triangle that its beam meets.
  double LargestDeviation = 0.0;

  /**
   * Adds a triangle around the return of a place, or around another range of its beam: facing the
   * sensor, small enough to meet no other beam. It is a patch of its own.
   */
  void AddFacet(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, double range);

  /// How far a point is from the nearest of the triangles that the beam towards it meets; infinite
  /// where it meets none.
  double GetDeviation(const lms3dVector& point) const;

  /// Whether the sensor sees a triangle's corners counter-clockwise.
  bool IsFacing(const std::array<std::int32_t, 3>& triangle) const;

  void DropUnusedPoints();
};

#endif
