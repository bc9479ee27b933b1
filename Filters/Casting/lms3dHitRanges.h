// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Replaces the ranges of packets by the distances to the planes of their triangles.
 */
#ifndef lms3dHitRanges_h
#define lms3dHitRanges_h

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

/// The method Intersect(std::int32_t triangle, const PacketT& packet, double* ranges) of
/// `intersector` computes the ranges of the beams that hit a triangle, metres. A hit is removed if
/// its range is 0 or less, or above the maximum.
template <typename Intersector, typename PacketT>
void lms3dStoreHitRanges(Intersector& intersector, double maximumRange, PacketT* packets, int count)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  for (int i = 0; i < count; ++i)
  {
    PacketT& packet = packets[i];
    std::uint32_t remaining = kernels.FindHits(packet);
    while (remaining != 0)
    {
      const std::int32_t triangle = packet.Triangle[lms3dGetFirstBit(remaining)];
      alignas(64) double ranges[lms3dBeamPacket::Size];
      intersector.Intersect(triangle, packet, ranges);
      remaining &= ~kernels.StoreRanges(ranges, triangle, maximumRange, packet);
    }
  }
}

#endif
