// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Planar patches: the patch of each return, and the plane of each patch.
 */
#ifndef lms3dPatches_h
#define lms3dPatches_h

#include "LocalMap/Patches/lms3dBeamVector.h"
#include "LocalMap/Patches/lms3dPlane.h"

#include <cstdint>
#include <vector>

/**
 * A patch is a set of returns that one plane explains. lms3dPatchGrower makes patches,
 * lms3dPatchMerger merges them, lms3dPatchRelabeler refines their borders.
 */
struct lms3dPatches
{
  /// The label of grid entries that belong to no patch: without a return, or with a facet.
  static constexpr std::int32_t None = -1;
  /// The label of returns that have no patch yet, while patches grow.
  static constexpr std::int32_t Free = -2;

  /// The share of the error bound within which merged planes must explain their returns. Borders
  /// need the rest.
  static constexpr double MergedShare = 0.8;

  /// The largest difference between the two planes of a crease, as a share of the error bound.
  static constexpr double CreaseShare = 0.85;

  /// Consecutive returns of one column, both ends included.
  struct Span
  {
    lms3dBeamSphere::GridIndex First;
    lms3dBeamSphere::GridIndex Last;
  };

  struct Patch
  {
    lms3dPlane Plane;
    lms3dPlaneFit Fit;
    /// The returns that grew the patch. Not updated when labels change later.
    std::vector<Span> Spans;
  };

  /// Whether a patch has too few returns for its plane to be reliable beyond them.
  bool HasFewReturns(std::int32_t patch) const
  {
    constexpr double MaximumFewReturns = 6.0;
    return this->Patches[patch].Fit.GetNumberOfReturns() <= MaximumFewReturns;
  }

  /// The number of returns that have the label of each patch. A pole counts once, a filled entry of
  /// the sphere not at all. Uses the threads of the calling TBB arena.
  std::vector<int> CountMembers(const lms3dBeamSphere& sphere) const;

  /// By grid index: the number of a patch, None or Free. All entries of a pole have the same label.
  lms3dBeamVector<std::int32_t> Labels;
  /// Patches without returns keep their number.
  std::vector<Patch> Patches;
  /// By grid index: whether a return that could not be a patch of its own has moved to the patch of
  /// a neighbour. Empty if none has.
  std::vector<bool> HasMoved;
};

#endif
