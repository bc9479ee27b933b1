// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides the joins of neighbours whose own ranges leave it open.
 */
#ifndef lms3dJoinResolver_h
#define lms3dJoinResolver_h

#include "LocalMap/Grid/lms3dPaddedGrid.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dTurnClassifier.h"

#include <array>
#include <cstdint>
#include <vector>

/// The flags of lms3dRangeJoins.
enum lms3dJoinFlag : std::uint8_t
{
  /// Joined with the next beam of the turn.
  lms3dJoinedAlongFan = 1,
  /// Joined with the same beam of the next turn.
  lms3dJoinedAlongTurn = 2
};

/// A beam and its neighbour, whose ranges alone do not decide.
struct lms3dUncertainJoin
{
  int Turn;
  int Beam;
  lms3dJoinFlag Towards;
  /// What the ranges alone show.
  lms3dDepthStep::Relation Relation;

  bool IsNoisy() const { return this->Relation == lms3dDepthStep::Noisy; }
};

/**
 * An uncertain pair has pairs of the same two surfaces beside it: along a fan in the turns before
 * and behind, along a turn at the beams beside. If noise makes a pair uncertain, the mean over up
 * to two such pairs on each side is classified (lms3dDepthStep), as far as their returns are joined
 * with the pair.
 *
 * Neighbours that are still uncertain are joined if the surface is whole around them: the three
 * other sides of both adjacent cells are joined. So the silhouette of an object, which ends at a
 * certain depth step, is not joined.
 */
class lms3dJoinResolver
{
public:
  using Flags = lms3dPaddedGrid<std::uint8_t>;

  /// Keeps references. `flags` are the certain joins, whose halo is not read.
  lms3dJoinResolver(const lms3dRangeGrid& grid, Flags& joins)
    : Grid(grid)
    , Joins(joins)
  {
  }

  /// How pairs are classified. Keeps references.
  struct Classifiers
  {
    const lms3dDepthStep& FanStep;
    const lms3dDepthStep& TurnStep;
    const lms3dTiltFinder& Tilts;
  };

  /// The relation of the mean pair around an uncertain pair.
  lms3dDepthStep::Relation ClassifyMean(
    const lms3dUncertainJoin& join, const Classifiers& classifiers) const;

  /// Joins pairs if the surface is whole around them.
  void JoinWhole(std::vector<lms3dUncertainJoin> uncertain);

  /// Separates pairs beside a step: a pair that is not joined, whose ranges differ by more than two
  /// depth steps in the same sense.
  void SeparateBesideSteps(const std::vector<lms3dUncertainJoin>& joins, double depthStep);

  /// Separates Loose pairs if at least three of the six other sides of both adjacent cells are
  /// open. Joins Gentle pairs if at most two are open, all in one cell. Beyond the edge of the
  /// scan, the sides of a cell are open for Gentle pairs only: there, the surface is not known to
  /// end.
  void DecideLoose(const std::vector<lms3dUncertainJoin>& joins);

private:
  bool IsBesideStep(const lms3dUncertainJoin& join, double minimum) const;
  void Separate(const lms3dUncertainJoin& join);
  double GetDifference(const lms3dUncertainJoin& join) const;
  bool DropBesideGap(const lms3dUncertainJoin& join);
  bool IsSurfaceAround(const lms3dUncertainJoin& join) const;
  std::array<int, 2> CountOpenSides(const lms3dUncertainJoin& join) const;
  bool IsInside(int turn, int beam) const;
  bool IsJoined(int turn, int beam, lms3dJoinFlag towards) const;
  bool IsJoinedAcross(int turn, int beam, bool isFan, int direction) const;
  std::array<lms3dDepthStep::Side, 2> GetSides(
    const lms3dUncertainJoin& join, const Classifiers& classifiers) const;
  template <typename Visitor>
  void ForEachParallel(const lms3dUncertainJoin& join, const Visitor& visit) const;

  const lms3dRangeGrid& Grid;
  Flags& Joins;
};

#endif
