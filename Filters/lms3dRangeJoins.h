// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which neighbours of a range grid lie on one surface.
 */
#ifndef lms3dRangeJoins_h
#define lms3dRangeJoins_h

#include "lms3dDepthStep.h"
#include "lms3dRangeGrid.h"

#include <cstdint>

/**
 * For each place two flags, by lms3dDepthStep. A pole is not joined with itself from turn to turn,
 * its places being one vertex. As in the grid, turns -1 to the number of turns + 1 and beams -1 to
 * the number of beams may be asked for.
 */
class lms3dRangeJoins
{
public:
  enum Flag : std::uint8_t
  {
    /// Joined with the next beam of the turn.
    AlongFan = 1,
    /// Joined with the same beam of the next turn.
    AlongTurn = 2
  };

  /// Uses the threads of the calling TBB arena.
  void Find(const lms3dRangeGrid& grid, double depthStep);

  /// The flags for each beam of a turn.
  const std::uint8_t* GetRow(int turn) const { return this->Flags.GetRow(turn); }

private:
  lms3dGhostGrid<std::uint8_t> Flags{ 0 };
};

#endif
