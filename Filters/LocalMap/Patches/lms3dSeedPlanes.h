// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes from which patches start to grow.
 */
#ifndef lms3dSeedPlanes_h
#define lms3dSeedPlanes_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <optional>

/// Fits planes to a seed and returns near it that belong to no patch yet.
class lms3dSeedPlanes
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// Keeps references. `tolerance` is metres along the beam.
  lms3dSeedPlanes(const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance)
    : Sphere(sphere)
    , Patches(patches)
    , Tolerance(tolerance)
  {
  }

  /// The plane of a square window of `stride` beams around a seed, if it explains a sample of up to
  /// 25 returns in the window, and all of these are free. The window must not exceed the rows.
  std::optional<lms3dPlane> FitWindow(int column, int row, int stride) const;

  /// The plane through a seed and free, joined neighbours: on two adjacent sides, or on one side,
  /// or none.
  lms3dPlane FitNeighbors(GridIndex seed) const;

private:
  bool IsFree(GridIndex index) const { return this->Patches.Labels[index] == lms3dPatches::Free; }
  bool IsFreeNeighbor(GridIndex seed, int side) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const double Tolerance;
};

#endif
