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
 * A vertex inside of the surface is smooth if the planes of all patches at it differ by at most 60
 * degrees and have at least twelve returns each, and if no offset is at it.
 *
 * Noise makes offsets where there are none. If ranges are noisy, an offset counts only if it is
 * larger than 1.5 times the bound.
 *
 * On a curved surface, planes have few returns and leave offsets between each other. There, only
 * the planes with twelve returns or more count, and offsets do not. The surface is curved if
 * these rules make at least half of the vertices smooth.
 */
class lms3dSmoothVertices
{
public:
  /// Keeps references to the map and its stars. `members` is the number of returns of each patch;
  /// the map has the patches with returns, in order. `maximumError` is the bound and `noise` the
  /// standard deviation of ranges, metres. Uses the threads of the calling TBB arena.
  lms3dSmoothVertices(const lms3dPatches& patches, const std::vector<int>& members,
    const lms3dBoundedMap& map, const lms3dVertexStars& stars, double maximumError, double noise);

  bool IsCurved() const { return this->IsSurfaceCurved; }

  /// By vertex, 1 for those that are smooth.
  const std::vector<std::uint8_t>& Get() const
  {
    return this->IsSurfaceCurved ? this->AreSmoothIfCurved : this->AreSmooth;
  }

private:
  bool IsNoisy() const { return this->MaximumOffset > 0.0; }
  bool IsSmallOffset(std::int32_t triangle) const;
  void AppendPatches(std::int32_t vertex, std::vector<std::int32_t>& patches) const;
  bool AppendPatchesBeyondOffsets(std::int32_t vertex, std::vector<std::int32_t>& patches) const;
  std::int32_t GetOnlyPatch(std::int32_t vertex) const;
  void Classify(std::int32_t vertex);

  const lms3dBoundedMap& Map;
  const lms3dVertexStars& Stars;
  /// 0 without noise.
  const double MaximumOffset;
  /// By the number of the patch in the map. Zeros if the plane is not reliable.
  std::vector<lms3dVector> Normals;
  bool IsSurfaceCurved = false;
  ///@{
  /// By vertex, 1 for those that are smooth by the rules for any surface and for a curved one.
  std::vector<std::uint8_t> AreSmooth;
  std::vector<std::uint8_t> AreSmoothIfCurved;
  ///@}
};

#endif
