// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which neighbours of a range grid lie on one surface.
 */
#ifndef lms3dRangeJoins_h
#define lms3dRangeJoins_h

#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <cstdint>
#include <vector>

/**
 * For each place two flags, by lms3dDepthStep. Where that is in doubt, neighbours are joined if the
 * surface is whole around them: if the other three sides of both cells beside them are joined, be it
 * for the same reason. So the silhouette of a thing, which ends at a sure step, is none. A pole
 * is not joined with itself from turn to turn, its places being one vertex. Places around the grid
 * may be asked for as well (lms3dPaddedGrid).
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

  /// Neighbours of which their ranges do not tell.
  struct UncertainJoin
  {
    int Turn;
    int Beam;
    Flag Towards;
  };

private:
  void ResolveUncertainJoins(const lms3dRangeGrid& grid);
  bool DropBesideGap(const lms3dRangeGrid& grid, const UncertainJoin& join);
  bool IsWholeAround(const lms3dRangeGrid& grid, const UncertainJoin& join) const;
  bool IsJoined(const lms3dRangeGrid& grid, int turn, int beam, Flag towards) const;

  lms3dPaddedGrid<std::uint8_t> Flags{ 0 };
  /// Of each turn.
  std::vector<std::vector<UncertainJoin>> UncertainJoins;
};

#endif
