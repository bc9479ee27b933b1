// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An Embree scene with one geometry and its acceleration structure.
 *
 * Only the sources named lms3dEmbree* include this header, so that no other source sees Embree.
 */
#ifndef lms3dEmbreeTree_h
#define lms3dEmbreeTree_h

#include "Casting/lms3dEmbreeHandles.h"
#include "Casting/lms3dNormalization.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <vector>

class lms3dEmbreeTree
{
public:
  /// Makes an empty Embree scene for a mesh. The normalization leaves out the `excluded` triangles,
  /// which are in increasing order and may not be all.
  explicit lms3dEmbreeTree(
    const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded = {});

  /// Returns a geometry without buffers and callbacks.
  lms3dEmbreeHandle<RTCGeometry> NewGeometry(RTCGeometryType type) const;

  /// Throws std::runtime_error if the last call of Embree in this thread failed.
  void ThrowOnError() const;

  /**
   * Builds the tree of a geometry on the calling thread and the threads of its TBB arena.
   * `progress` may be empty. It receives Embree's estimate of the work that is done, on the calling
   * thread only; a small scene may give no report at all. Throws lms3dBuildStopped if `progress`
   * returned false, and std::runtime_error if Embree fails, for example because memory is short.
   */
  void Build(RTCGeometry geometry, RTCBuildQuality quality, const lms3dProgress& progress);

  /// Converts world coordinates, metres, to coordinates of the Embree scene.
  const lms3dNormalization& GetNormalization() const { return this->Normalization; }

  RTCScene GetScene() const { return this->Scene.get(); }

private:
  const lms3dNormalization Normalization;
  lms3dEmbreeHandle<RTCDevice> Device;
  lms3dEmbreeHandle<RTCScene> Scene;
};

#endif
