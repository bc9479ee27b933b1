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

/// Sets Triangle of all beams to one triangle or to lms3dBeamPacket::NoTriangle, and Range to NoRange.
inline void lms3dSetTriangle(std::int32_t triangle, lms3dBeamPacket& packet)
{
  std::fill_n(packet.Range, lms3dBeamPacket::Size, lms3dBeamPacket::NoRange);
  std::fill_n(packet.Triangle, lms3dBeamPacket::Size, triangle);
}

#endif
