// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles that Embree itself intersects, in single precision.
 */
#ifndef lms3dEmbreeTriangles_h
#define lms3dEmbreeTriangles_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"

#include <memory>

class lms3dEmbreeTree;

class lms3dEmbreeTriangles
{
public:
  /// Builds the tree of a mesh with at least one triangle, see lms3dEmbreeTree::Build. `indices`
  /// replace the mesh's triangles, one for one. The mesh and the indices must outlive this object
  /// and keep their addresses: Embree shares the indices.
  lms3dEmbreeTriangles(const lms3dTriangleMesh& mesh, const lms3dTriangleIndices& indices,
    const lms3dProgress& progress);

  ~lms3dEmbreeTriangles();
  lms3dEmbreeTriangles(const lms3dEmbreeTriangles&) = delete;
  lms3dEmbreeTriangles& operator=(const lms3dEmbreeTriangles&) = delete;

  /// Sets Triangle of the active beams of `count` packets, at least one; Range becomes NoRange.
  /// Several threads may call this at once.
  void Cast(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const;

  /// The same for beams that start at points of their own.
  void CastFree(double maximumRange, lms3dFreePacket* packets, int count) const;

  const lms3dEmbreeTree& GetTree() const { return *this->Tree; }

private:
  std::unique_ptr<lms3dEmbreeTree> Tree;
};

#endif
