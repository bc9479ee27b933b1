// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes returns out of patches, and divides patches that cannot be meshed.
 */
#ifndef lms3dPatchSplitter_h
#define lms3dPatchSplitter_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Collects what to change. If beams are not regular, only the neighbourhood of a fault leaves its
 * patch, so that a fault at one place does not cost a large patch.
 */
class lms3dPatchSplitter
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// Keeps references. `members` is the number of returns of each patch.
  lms3dPatchSplitter(
    const lms3dBeamSphere& sphere, lms3dPatches& patches, const std::vector<int>& members);

  /// Lets a return leave its patch. A return that is alone in its patch loses it. Does nothing if
  /// the entry has no patch.
  void Release(GridIndex index);

  /// Lets the returns of a patch that are next to a beam leave the patch. If there are none,
  /// divides the patch.
  void ReleaseAround(GridIndex beam, std::int32_t patch);

  /// Divides a patch into up to four parts.
  void Divide(std::int32_t patch);

  /// Gives each return of a patch a patch of its own.
  void Scatter(std::int32_t patch);

  /// Lets all returns of a patch lose it.
  void Dissolve(std::int32_t patch);

  /// Makes the changes. Returns false if there are none.
  bool Apply();

private:
  /// The columns and rows of a patch, and the size of its parts.
  struct Extent
  {
    std::array<int, 2> First;
    std::array<int, 2> Last;
    int Size;
    /// The number of each part's patch, or None.
    std::array<std::int32_t, 4> Parts;
  };

  void SetAffected(std::int32_t patch);
  bool ReleaseRing(GridIndex beam, std::int32_t patch, int radius);
  void FindExtents();
  std::int32_t GetNewLabel(GridIndex index, std::int32_t label);
  std::int32_t GetPart(GridIndex index, std::int32_t label);
  std::int32_t AddPatch(const lms3dPlane* plane, GridIndex index);

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const std::vector<int>& Members;
  /// By grid index.
  std::vector<bool> IsReleased;
  ///@{
  /// By patch.
  std::vector<bool> IsDivided;
  std::vector<bool> IsScattered;
  std::vector<bool> IsDissolved;
  /// Not 0 for patches that Apply() may change.
  std::vector<std::uint8_t> IsAffected;
  std::vector<Extent> Extents;
  ///@}
};

#endif
