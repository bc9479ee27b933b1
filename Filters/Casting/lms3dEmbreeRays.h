// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One packet of beams as Embree's rays.
 *
 * Rays are in the coordinates of the normalized scene. To keep single precision sufficient, a ray
 * of a far sensor does not start at the sensor but further along its beam, at the ray offset.
 */
#ifndef lms3dEmbreeRays_h
#define lms3dEmbreeRays_h

#include "Casting/lms3dEmbreeRayPacket.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

/// Serves one packet after the other, all with the same origin. Keeps references to `tree` and
/// `origin`, which must outlive the object.
class lms3dEmbreeRays
{
public:
  /// `packet` is any packet whose directions are set.
  lms3dEmbreeRays(
    const lms3dEmbreeTree& tree, const lms3dRayOrigin& origin, const lms3dBeamPacket& packet);

  /// Prepares the rays of a packet, without hits. Returns the active beams that can hit the scene;
  /// if there are none, Intersect must not be called.
  std::uint32_t Prepare(const lms3dBeamPacket& packet);

  ///@{
  /// Ends the rays of some beams a little beyond their hits, in units of the scene's diagonal: all
  /// rays of this packet, or a part of them in Embree's own memory, which also get a geometry.
  void Clip(const lms3dNarrowHits& hits, std::uint32_t beams);
  void Clip(const lms3dNarrowHits& hits, std::uint32_t beams, unsigned int geometry,
    const lms3dRayRange& rays) const;
  ///@}

  /// Finds the nearest hits of some beams. The context is passed on to callbacks.
  void Intersect(std::uint32_t beams, lms3dEmbreeContext& context)
  {
    this->Packet.Intersect(beams, context);
  }

  /// Copies the triangles that were hit to the packet.
  void StoreTriangles(lms3dBeamPacket& packet) const { this->Packet.StoreTriangles(packet); }

private:
  void ShiftOrigins(const lms3dBeamPacket& packet);

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  lms3dEmbreeRayPacket Packet;
  const lms3dRayOrigin& Origin;

  /// The directions in which the scene lies.
  const lms3dCone Cone;

  /// How far along its beam each ray starts, metres.
  const double RayOffset;

  /// The same in units of the scene's diagonal.
  const float NarrowRayOffset;
  const float TFar;

  /// The beams whose rays start near enough to the scene.
  std::uint32_t Near = 0;
};

#endif
