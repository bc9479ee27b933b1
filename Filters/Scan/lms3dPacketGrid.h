// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The grid of a scan's beams, divided into packets, and where a packet's hits go.
 */
#ifndef lms3dPacketGrid_h
#define lms3dPacketGrid_h

#include "Casting/lms3dBeamGrid.h"
#include "Kernels/lms3dBeamPacket.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// Beam Side * i + j of a packet belongs to its turn i and elevation j. Beyond the end of the grid
/// a packet repeats the last turn or beam, inactive, so that it stays coherent.
struct lms3dPacketGrid
{
  static constexpr int Side = lms3dBeamGrid::Side;
  static_assert(Side * Side == lms3dBeamPacket::Size, "a packet is square");

  int Turns;
  int Beams;

  /// Returns the beams of the packet at a turn and beam that the grid has.
  std::uint32_t GetActive(int firstTurn, int firstBeam) const
  {
    const int turns = std::min(Side, this->Turns - firstTurn);
    const int beams = std::min(Side, this->Beams - firstBeam);
    std::uint32_t active = 0;
    for (int turn = 0; turn < turns; ++turn)
    {
      active |= ((1u << beams) - 1u) << (Side * turn);
    }
    return active;
  }

  /// Copies the active beams of a packet to their slots.
  void Store(
    int firstTurn, int firstBeam, const lms3dBeamPacket& packet, const lms3dBeamHits& hits) const
  {
    const int turns = std::min(Side, this->Turns - firstTurn);
    const int beams = std::min(Side, this->Beams - firstBeam);
    std::size_t slot = static_cast<std::size_t>(firstTurn) * this->Beams + firstBeam;
    for (int turn = 0; turn < turns; ++turn, slot += this->Beams)
    {
      const double* range = packet.Range + Side * turn;
      const std::int32_t* triangle = packet.Triangle + Side * turn;
      if (beams == Side)
      {
        // Without a call, unlike std::copy_n.
        std::memcpy(hits.Ranges + slot, range, Side * sizeof(*range));
        std::memcpy(hits.Triangles + slot, triangle, Side * sizeof(*triangle));
        continue;
      }
      std::copy_n(range, beams, hits.Ranges + slot);
      std::copy_n(triangle, beams, hits.Triangles + slot);
    }
  }
};

#endif
