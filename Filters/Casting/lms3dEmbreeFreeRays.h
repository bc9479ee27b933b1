// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One packet of beams that start at points of their own, as Embree's rays.
 *
 * Each ray starts where lms3dEmbreeRays lets a ray of the same beam start.
 */
#ifndef lms3dEmbreeFreeRays_h
#define lms3dEmbreeFreeRays_h

#include "Casting/lms3dEmbreeRayPacket.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

/// Serves one packet after the other. Keeps a reference to `tree`, which must outlive the object.
class lms3dEmbreeFreeRays
{
public:
  lms3dEmbreeFreeRays(const lms3dEmbreeTree& tree, double maximumRange);

  /// Prepares the rays of a packet, without hits. Returns the active beams that can hit the scene;
  /// if there are none, Intersect must not be called. Fills the packet's NarrowDirection.
  std::uint32_t Prepare(lms3dFreePacket& packet);

  ///@{
  /// Ends the rays of some beams a little beyond the packet's Range: all rays of this packet, or a
  /// part of them in Embree's own memory, which also get a geometry.
  void Clip(const lms3dFreePacket& packet, std::uint32_t beams);
  void Clip(const lms3dFreePacket& packet, std::uint32_t beams, unsigned int geometry,
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
  void ClearOffsets();
  std::uint32_t OffsetStarts(
    const lms3dFreePacket& packet, std::uint32_t beams, float* const* starts);
  bool OffsetStart(const lms3dFreePacket& packet, int beam);

  lms3dEmbreeRayPacket Packet;
  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dSceneFrame Frame;
  const double MaximumRange;

  /// The end of a ray without an offset.
  const float TFar;

  /// How far along its beam each ray starts, metres, and in units of the scene's diagonal.
  double RayOffsets[lms3dBeamPacket::Size];
  float NarrowRayOffsets[lms3dBeamPacket::Size];
  bool HasOffsets = false;
};

#endif
