// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds groups of neighbouring beams: beams without a return, returns at one depth, and
 * returns that stand out from the surface around them.
 */
#ifndef lms3dBeamGroups_h
#define lms3dBeamGroups_h

#include "LocalMap/Gaps/lms3dBeamStates.h"
#include "LocalMap/Grid/lms3dDepthStep.h"

#include <cstdint>
#include <vector>

/// Finds all groups of at most a given number of beams. Larger groups cost no more than small ones.
class lms3dBeamGroups
{
public:
  using Groups = std::vector<std::vector<int>>;

  /// Keeps a reference.
  explicit lms3dBeamGroups(const lms3dBeamStates& states)
    : States(states)
  {
  }

  /// The groups of at most `maximumSize` missing beams, next to each other in a fan or in a turn.
  Groups FindMissing(int maximumSize);

  /**
   * The groups of at most `maximumSize` returns at one depth: the ranges of neighbours, diagonals
   * included, differ by at most the depth step. Returns on both sides of a missing beam are
   * neighbours as well, so that a thin thing stays one group. Groups with the return of a pole do
   * not count. Uses the threads of the calling TBB arena.
   */
  Groups FindAtOneDepth(int maximumSize, const lms3dDepthStep& step);

  /// The side of a surface on which returns stand out.
  enum Side
  {
    Farther = -1,
    Nearer = 1
  };

  /**
   * The groups of at most `maximumSize` neighbouring returns that stand out on one side of a
   * surface by more than `height`, metres, and less than the depth step: each return lies on this
   * side of the lines through the returns beside it, in its fan and in its turn. Diagonal
   * neighbours and returns on both sides of a missing beam belong to one group. Uses the threads of
   * the calling TBB arena.
   */
  Groups FindStandingOut(int maximumSize, Side side, double height, const lms3dDepthStep& step);

private:
  /// The number of neighbours beside a place in its fan or in its turn. They come first.
  static constexpr int StraightNeighbors = 4;

  enum Mark : std::uint8_t
  {
    New,
    InSmallGroup,
    InLargeGroup
  };

  template <typename Visitor>
  Groups FindFrom(const std::vector<int>& seeds, int maximumSize, const Visitor& forEachNeighbor);
  template <typename Visitor>
  bool Flood(int seed, int maximumSize, const Visitor& forEachNeighbor, std::vector<int>& group);
  template <typename Visitor>
  void ForEachAtOneDepth(int place, const lms3dDepthStep& step, const Visitor& visit) const;
  template <typename Visitor>
  void ForEachNear(int place, const Visitor& visit) const;
  template <typename Finder>
  std::vector<int> FindInTurns(const Finder& findInTurn) const;
  std::vector<int> FindFirstOfTurn(int turn, const lms3dDepthStep& step) const;
  std::vector<int> FindStandingOutOfTurn(
    int turn, Side side, double height, const lms3dDepthStep& step) const;
  bool StandsOut(int place, Side side, double height, const lms3dDepthStep& step) const;
  bool MayBeFirst(int place, const lms3dDepthStep& step) const;

  const lms3dBeamStates& States;
  /// By place.
  std::vector<Mark> Marks;
};

#endif
