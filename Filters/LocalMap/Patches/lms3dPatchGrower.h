// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Grows planar patches over the returns of a scan.
 */
#ifndef lms3dPatchGrower_h
#define lms3dPatchGrower_h

#include "LocalMap/Patches/lms3dOpenRuns.h"
#include "LocalMap/Patches/lms3dPatches.h"
#include "LocalMap/Patches/lms3dSeedPlanes.h"

#include <cstdint>
#include <vector>

/**
 * Region growing. Seeds lie on ever finer lattices. From each seed, a patch floods the joined
 * neighbours that are within the tolerance of its plane, column by column. The plane is fitted to
 * the flooded returns and the flood repeats, until the plane converges. Finally, each return
 * without a patch becomes a seed, so every return gets a patch, if only of its own.
 */
class lms3dPatchGrower
{
public:
  /// Keeps a reference to the sphere. `tolerance` is metres along the beam, above 0.
  lms3dPatchGrower(const lms3dBeamSphere& sphere, double tolerance);

  /// Returns the patches. To be called once.
  lms3dPatches Grow();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Span = lms3dPatches::Span;

  /// Consecutive entries of a column, beside a span.
  struct Neighbors
  {
    GridIndex First;
    /// The entry that says whether the first neighbour is joined with the span.
    GridIndex FirstJoin;
    int FirstRow;
    int Count;
  };

  void GrowFromLattice(int stride);
  void GrowFromFreeReturns();
  void GrowFrom(GridIndex seed, lms3dPlane plane);
  void Flood(GridIndex seed, const lms3dPlane& plane, lms3dPatches::Patch& patch);
  Span FloodSpan(const Span& run, const lms3dColumnPlane& plane);
  void QueueNeighbors(const Span& span, int side, const lms3dPlane& plane);
  void MarkOpen(const Neighbors& neighbors, const lms3dColumnPlane& plane);
  void MarkOpenOfRegular(const Neighbors& neighbors, lms3dColumnPlane plane);
  void Release(lms3dPatches::Patch& patch);
  bool HasMoved(const lms3dPatches::Patch& patch, const lms3dPlane& plane) const;

  bool IsFree(GridIndex index) const { return this->Result.Labels[index] == lms3dPatches::Free; }
  bool Fits(GridIndex index, const lms3dPlane& plane) const;

  const lms3dBeamSphere& Sphere;
  const double Tolerance;
  lms3dPatches Result;
  const lms3dSeedPlanes SeedPlanes;
  /// Runs of joined returns on the plane from which the flood goes on.
  std::vector<Span> Queue;
  /// The neighbours of a span at which the flood can go on.
  lms3dOpenRuns Runs;
};

#endif
