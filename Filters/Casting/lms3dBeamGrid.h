// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a scan as a ray caster sees them.
 */
#ifndef lms3dBeamGrid_h
#define lms3dBeamGrid_h

#include <array>
#include <cstddef>
#include <cstdint>

/// A hit for each beam of a scan, ordered by turn, then by beam. The arrays belong to the caller.
struct lms3dBeamHits
{
  /// Metres.
  double* Ranges;

  /// Indices into the caster's mesh, lms3dBeamPacket::NoTriangle if there is no hit.
  std::int32_t* Triangles;
};

/// The arrays belong to the caller. If there are FanAxes, the direction of a beam is the fan's axis
/// in its turn times the cosine of its elevation, plus the upward axis times the sine. Otherwise
/// the beams have any directions, neighbours similar ones, and only the numbers of turns and beams
/// count.
struct lms3dBeamGrid
{
  /// A packet has this number of turns and beams, so that it is nearly square in angle at the
  /// horizon and its beams traverse the same boxes of a tree. Beam Side * i + j of a packet belongs
  /// to its turn i and its beam j.
  static constexpr int Side = 4;

  /// Returns how many packets cover a number of beams or turns.
  static int CountPackets(int beamsOrTurns) { return (beamsOrTurns - 1) / Side + 1; }

  std::size_t CountPackets() const
  {
    return static_cast<std::size_t>(CountPackets(this->Turns)) * CountPackets(this->Beams);
  }

  int Turns;
  int Beams;

  /// Null, or one value for each turn: unit vectors in world coordinates. They turn by TurnStep
  /// degrees, not negative, from one to the next.
  const std::array<double, 3>* FanAxes = nullptr;
  double TurnStep = 0.0;

  /// One value for each beam. Elevations increase and lie within -90 to 90 degrees.
  const double* Cosines = nullptr;
  const double* Sines = nullptr;

  /// A unit vector in world coordinates.
  std::array<double, 3> Up = {};
};

#endif
