// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Planar patches: which patch each return belongs to, and the patches' planes.
 */
#ifndef lms3dPatches_h
#define lms3dPatches_h

#include "LocalMap/Patches/lms3dPlane.h"

#include <cstdint>
#include <vector>

struct lms3dPatches
{
  /// Of places without a return.
  static constexpr std::int32_t None = -1;
  /// Of returns that no patch has taken yet.
  static constexpr std::int32_t Free = -2;

  /// The share of the bound that merged planes may use up; the borders need the rest.
  static constexpr double MergedShare = 0.8;

  /// Returns of a column, from one place to another, both included.
  struct Span
  {
    lms3dBeamSphere::GridIndex First;
    lms3dBeamSphere::GridIndex Last;
  };

  struct Patch
  {
    lms3dPlane Plane;
    lms3dPlaneFit Fit;
    std::vector<Span> Spans;
  };

  /// The number of each patch's returns; a pole is one.
  std::vector<int> CountMembers(const lms3dBeamSphere& sphere) const;

  /// For each place the patch of its return; all places of a pole have one.
  std::vector<std::int32_t> Labels;
  std::vector<Patch> Patches;
};

#endif
