// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sixteen rays as Embree holds them.
 *
 * Rays are in the coordinates of the normalized scene.
 */
#ifndef lms3dEmbreeRayPacket_h
#define lms3dEmbreeRayPacket_h

#include "Casting/lms3dEmbreeTree.h"
#include "Kernels/lms3dBeamPacket.h"

#include <cstdint>

#if LMS3D_EMBREE_MAJOR >= 4
using lms3dEmbreeContext = RTCRayQueryContext;
#else
using lms3dEmbreeContext = RTCIntersectContext;
#endif

/// Keeps a reference to `tree`, which must outlive the object.
class lms3dEmbreeRayPacket
{
public:
  /// In diagonals of the scene from its centre. A ray that can hit starts within two and a half;
  /// one that points away from a far scene starts even farther away than the sensor, where single
  /// precision, and Embree's assertions, end.
  static constexpr double MaximumOriginDistance = 10.0;

  explicit lms3dEmbreeRayPacket(const lms3dEmbreeTree& tree);

  /// Sets the rays' directions, and removes their hits.
  void SetDirections(const lms3dBeamPacket& packet);

  /// Returns where a ray ends that starts at a ray offset and counts up to a range, both in metres.
  float GetTFar(double range, double rayOffset) const;

  /// Finds the nearest hits of some beams. The context is passed on to callbacks.
  void Intersect(std::uint32_t beams, lms3dEmbreeContext& context);

  /// Copies the triangles that were hit to the packet.
  void StoreTriangles(lms3dBeamPacket& packet) const;

  const lms3dNormalization& GetNormalization() const { return this->Tree.GetNormalization(); }

  RTCRayHit16 RayHit;

private:
  const lms3dEmbreeTree& Tree;
};

#endif
