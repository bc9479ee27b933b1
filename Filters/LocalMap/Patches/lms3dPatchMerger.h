// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Merges patches that one plane explains.
 */
#ifndef lms3dPatchMerger_h
#define lms3dPatchMerger_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <utility>
#include <vector>

class lms3dPatchMerger
{
public:
  /// `maximumError` is the bound of the whole map, metres along the beam.
  lms3dPatchMerger(const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError);

  /// Patches side by side become one where a plane of either, or of both, explains all returns.
  void Merge();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Pair = std::pair<std::int32_t, std::int32_t>;

  std::vector<Pair> FindNeighbors() const;
  int FindRoot(int patch);
  bool TryToMerge(int large, int small);
  bool Explains(const lms3dPlane& plane, const lms3dPatches::Patch& patch) const;
  void Join(int large, int small, const lms3dPlane& plane);
  void WriteLabels();

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const double Tolerance;
  std::vector<int> Parents;
};

#endif
