// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which neighbours of a range grid lie on one surface.
 */
#ifndef lms3dRangeJoins_h
#define lms3dRangeJoins_h

#include "LocalMap/Grid/lms3dJoinResolver.h"
#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <cstdint>
#include <vector>

class lms3dGrazedStrips;
struct lms3dTurnJoins;

/**
 * Holds two flags for each beam of each turn, set if the beam lies on one surface with the next
 * beam or with the next turn (lms3dDepthStep). If that is uncertain, lms3dJoinResolver looks at the
 * surface around. lms3dGrazedStrips joins surfaces that beams graze. The noise is estimated from
 * the scan itself (lms3dScanNoise.h).
 *
 * The entries of a pole are one vertex and not joined from turn to turn. Ranges count from where
 * the beams start. If the platform turns during a fan, neighbours in the fan are compared at one
 * platform angle (lms3dSteadyFans). Returns beyond the axis (lms3dMapGeometry) are not joined with
 * any other. The halo of the grid can be read as well (lms3dPaddedGrid).
 */
class lms3dRangeJoins
{
public:
  using Flag = lms3dJoinFlag;
  static constexpr Flag AlongFan = lms3dJoinedAlongFan;
  static constexpr Flag AlongTurn = lms3dJoinedAlongTurn;

  /// Finds all joins. `depthStep` is metres, at least 0. Reuses the memory. Uses the threads of the
  /// calling TBB arena. Without a `geometry`, beams are regular.
  void Find(
    const lms3dRangeGrid& grid, double depthStep, const lms3dMapGeometry* geometry = nullptr);

  /// The flags for each beam of a turn.
  const std::uint8_t* GetRow(int turn) const { return this->Flags.GetRow(turn); }

private:
  lms3dTurnJoins GetTurnJoins(int turn);
  void KeepFans(const lms3dRangeGrid& grid, const lms3dDepthStep& step);
  void FindAlongSteadyFans(
    const lms3dRangeGrid& grid, const lms3dDepthStep& step, const lms3dMapGeometry& geometry);
  void SeparateBeyondAxis(const lms3dRangeGrid& grid, const lms3dMapGeometry& geometry);
  void Separate(const lms3dRangeGrid& grid, int turn, int beam);
  void ResolveMeans(const lms3dRangeGrid& grid, const lms3dJoinResolver::Classifiers& classifiers);
  void JoinGrazed(const lms3dRangeGrid& grid, const lms3dGrazedStrips& strips);
  void ResolveRest(const lms3dRangeGrid& grid, double depthStep);

  lms3dPaddedGrid<std::uint8_t> Flags{ 0 };
  /// The joins along fans only, while others are found.
  lms3dPaddedGrid<std::uint8_t> Fans{ 0 };
  /// By turn.
  std::vector<std::vector<lms3dUncertainJoin>> UncertainJoins;
  ///@{
  /// Pairs that the surface around can change, by turn.
  std::vector<std::vector<lms3dUncertainJoin>> Creases;
  std::vector<std::vector<lms3dUncertainJoin>> Loose;
  ///@}
};

#endif
