// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts beams that are not regular at the finished mesh of a patch.
 */
#ifndef lms3dRayCheck_h
#define lms3dRayCheck_h

#include "LocalMap/Bounded/lms3dPatchTriangulation.h"

#include <utility>
#include <vector>

/**
 * Beams that are not regular (lms3dMapGeometry) start beside the origin. Near a border, such a beam
 * can pass beside its own patch and hit a neighbour. This is no fault if the hit lies within the
 * bound of the return, or behind it, where the beam does not reach.
 */
struct lms3dRayCheck
{
  using GridIndex = lms3dBeamSphere::GridIndex;
  /// A beam, and the distance of its return from a triangle that the beam hits, metres.
  using Hit = std::pair<GridIndex, double>;

  /// The returns of the patch whose beams hit no triangle of the patch within the bound, sorted.
  std::vector<GridIndex> Uncovered;
  /// The returns of other patches whose beams hit the patch within the bound.
  std::vector<Hit> Others;
  /// The beams of other patches, and beams without a return, that hit the patch before their
  /// returns.
  std::vector<GridIndex> Blocked;
  /// The largest distance of a return of the patch from the nearest triangle that its beam hits,
  /// metres. Does not count poles.
  double LargestDeviation = 0.0;
};

/// Checks the triangles of one patch. `members` is the number of its returns, `maximumError` the
/// bound, metres.
lms3dRayCheck lms3dCheckRays(const lms3dBeamSphere& sphere, const lms3dPatches& patches, int patch,
  int members, const lms3dPatchTriangulation& triangulation, double maximumError);

#endif
