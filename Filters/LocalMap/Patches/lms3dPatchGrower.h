// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Grows planar patches over the returns of a scan.
 */
#ifndef lms3dPatchGrower_h
#define lms3dPatchGrower_h

#include "LocalMap/Patches/lms3dPatches.h"

/**
 * From seeds on ever finer lattices, patches flood the neighbours that are joined and within the
 * tolerance (metres along the beam) of the plane, column by column. The plane is fitted anew to
 * what a flood reached, and the flood repeated, until the plane stays. What no larger patch takes
 * ends up in patches of a few returns, or of one.
 */
class lms3dPatchGrower
{
public:
  lms3dPatchGrower(const lms3dBeamSphere& sphere, double tolerance);

  lms3dPatches Grow();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Span = lms3dPatches::Span;

  void GrowFromLattice(int stride);
  void GrowFromRest();
  void GrowFrom(GridIndex seed, lms3dPlane plane);
  bool FitWindow(int column, int row, int stride, lms3dPlane& plane) const;
  lms3dPlane FitCorner(GridIndex seed) const;

  void Flood(GridIndex seed, const lms3dPlane& plane, lms3dPatches::Patch& patch);
  Span FloodSpan(GridIndex seed, const lms3dColumnPlane& plane);
  void QueueNeighbors(const Span& span, int side, const lms3dPlane& plane);
  void Release(lms3dPatches::Patch& patch);
  bool HasMoved(const lms3dPatches::Patch& patch, const lms3dPlane& plane) const;

  bool IsFree(GridIndex index) const { return this->Result.Labels[index] == lms3dPatches::Free; }
  bool Fits(GridIndex index, const lms3dPlane& plane) const;

  const lms3dBeamSphere& Sphere;
  const double Tolerance;
  lms3dPatches Result;
  std::vector<GridIndex> Queue;
};

#endif
