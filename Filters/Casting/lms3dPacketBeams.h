// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Access to the beams of a packet.
 */
#ifndef lms3dPacketBeams_h
#define lms3dPacketBeams_h

#include "Geometry/lms3dVector.h"
#include "Kernels/lms3dBeamPacket.h"

#include <algorithm>
#include <cstdint>

inline lms3dVector lms3dGetDirection(const lms3dBeamPacket& packet, int beam)
{
  return { packet.Direction[0][beam], packet.Direction[1][beam], packet.Direction[2][beam] };
}

inline lms3dVector lms3dGetOrigin(const lms3dFreePacket& packet, int beam)
{
  return { packet.Origin[0][beam], packet.Origin[1][beam], packet.Origin[2][beam] };
}

/// Returns whether a triangle at a range would be the nearest hit of a beam. Of two triangles at
/// the same range, the one with the smaller index is.
inline bool lms3dIsNearerHit(
  double range, std::int32_t triangle, const lms3dBeamPacket& packet, int beam)
{
  return range < packet.Range[beam] ||
    (range == packet.Range[beam] && triangle < packet.Triangle[beam]);
}

/// Returns the beams in `beams` whose nearest hit is a triangle.
inline std::uint32_t lms3dFindBeams(
  std::int32_t triangle, std::uint32_t beams, const lms3dBeamPacket& packet)
{
  std::uint32_t found = 0;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    found |= packet.Triangle[beam] == triangle ? beams & (1u << beam) : 0u;
  }
  return found;
}

/// Sets Triangle of all beams to one triangle or to lms3dBeamPacket::NoTriangle, and Range to
/// NoRange.
inline void lms3dSetTriangle(std::int32_t triangle, lms3dBeamPacket& packet)
{
  std::fill_n(packet.Range, lms3dBeamPacket::Size, lms3dBeamPacket::NoRange);
  std::fill_n(packet.Triangle, lms3dBeamPacket::Size, triangle);
}

#endif
