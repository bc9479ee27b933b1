// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles for which Embree only finds candidates; lms3dExactView decides which beams hit.
 *
 * Embree's tree is made of boxes, one around each triangle or pair, a little larger than single
 * precision can be wrong. So Embree never rules out a triangle that a beam hits.
 */
#ifndef lms3dEmbreeCandidates_h
#define lms3dEmbreeCandidates_h

#include "Casting/lms3dExactView.h"
#include "Casting/lms3dGridCaster.h"
#include "Casting/lms3dNormalization.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"

#include <memory>

class lms3dEmbreeCandidates
{
public:
  /// Builds the tree of a mesh with at least one triangle, see lms3dEmbreeTree::Build. The mesh
  /// must outlive this object.
  lms3dEmbreeCandidates(const lms3dTriangleMesh& mesh, const lms3dProgress& progress);

  ~lms3dEmbreeCandidates();
  lms3dEmbreeCandidates(const lms3dEmbreeCandidates&) = delete;
  lms3dEmbreeCandidates& operator=(const lms3dEmbreeCandidates&) = delete;

  /// Fills Triangle of some of at most 64 packets, as lms3dExactView does. The directions of the
  /// first packet must be set in any case. The view must be of the same mesh, with the unit of this
  /// object. Several threads may call this at once.
  void Cast(
    const lms3dExactView& view, lms3dBeamPacket* packets, const lms3dPacketMask& which) const;

  /// The same for `count` packets of beams that start at points of their own. Fills Triangle, and
  /// Range as lms3dExactFreeTest does.
  void CastFree(double maximumRange, lms3dFreePacket* packets, int count) const;

  const lms3dNormalization& GetNormalization() const;

  /// Returns whether the normalization leaves out some triangles.
  bool HasOutliers() const;

  /// Returns the diagonal of the scene without its outliers, metres.
  double GetUnit() const;

  /// Returns whether a point, world coordinates, is inside the bounding sphere of the scene without
  /// its outliers.
  bool IsInBoundingSphere(const double point[3]) const;

  /// Returns the directions in which the scene lies, seen from an origin in world coordinates. With
  /// outliers, these are all directions.
  lms3dCone GetCone(const double origin[3]) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
