// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the vertices of the map at which the surface is smooth.
 */
#ifndef lms3dSmoothVertices_h
#define lms3dSmoothVertices_h

#include "LocalMap/Bounded/lms3dVertexStars.h"
#include "LocalMap/Patches/lms3dPatches.h"

#include <cstdint>
#include <vector>

/**
 * A vertex is smooth if the planes of all patches at it differ by at most 60 degrees and have at
 * least twelve returns each, and if no offset is at it.
 *
 * Noise makes offsets where there are none. If ranges are noisy, an offset counts only if it is
 * larger than 1.5 times the bound.
 */
class lms3dSmoothVertices
{
public:
  /// Keeps a reference to the map. `members` is the number of returns of each patch; the map has
  /// the patches with returns, in order. `maximumError` is the bound and `noise` the standard
  /// deviation of ranges, metres.
  lms3dSmoothVertices(const lms3dPatches& patches, const std::vector<int>& members,
    const lms3dBoundedMap& map, double maximumError, double noise);

  /// `stars` must belong to the map.
  bool IsSmooth(const lms3dVertexStars& stars, std::int32_t vertex) const;

private:
  bool IsNoisy() const { return this->MaximumOffset > 0.0; }
  bool AreSmooth(std::int32_t a, std::int32_t b) const;
  bool HasOnePatch(const lms3dVertexStars& stars, std::int32_t vertex) const;
  bool MayBeSmooth(const lms3dVertexStars& stars, std::int32_t vertex) const;
  bool IsSmallOffset(const lms3dVertexStars& stars, std::int32_t triangle) const;
  void AppendPatches(
    const lms3dVertexStars& stars, std::int32_t vertex, std::vector<std::int32_t>& patches) const;

  const lms3dBoundedMap& Map;
  /// 0 without noise.
  const double MaximumOffset;
  /// By the number of the patch in the map. Zeros if the plane is not reliable.
  std::vector<lms3dVector> Normals;
};

#endif
