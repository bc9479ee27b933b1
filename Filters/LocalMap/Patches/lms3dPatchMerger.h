// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Merges neighbouring patches that one plane explains.
 */
#ifndef lms3dPatchMerger_h
#define lms3dPatchMerger_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <utility>
#include <vector>

/**
 * Two patches merge if joined returns lie side by side, and if all returns of the smaller patch are
 * within the tolerance of the larger patch's plane, or all returns of both are within the tolerance
 * of their common least-squares plane. A few passes follow until nothing merges, with union-find
 * for the labels.
 */
class lms3dPatchMerger
{
public:
  /// Keeps references. `maximumError` is the error bound of the map, metres along the beam; the
  /// tolerance is lms3dPatches::MergedShare of it.
  lms3dPatchMerger(const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError);

  /// Merges the patches and updates their labels. The larger patch keeps its number. Uses the
  /// threads of the calling TBB arena.
  void Merge();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Pair = std::pair<std::int32_t, std::int32_t>;

  std::vector<Pair> FindNeighbors() const;
  int FindRoot(int patch);
  bool TryToMerge(int large, int small);
  bool Explains(const lms3dPlane& plane, const lms3dPatches::Patch& patch) const;
  bool ExplainsSpan(const lms3dColumnPlane& plane, const lms3dPatches::Span& span) const;
  bool ExplainsSpanOfRegular(const lms3dColumnPlane& plane, const lms3dPatches::Span& span) const;
  void Join(int large, int small, const lms3dPlane& plane);

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const double Tolerance;
  /// The union-find forest of patches.
  std::vector<int> Parents;
};

#endif
