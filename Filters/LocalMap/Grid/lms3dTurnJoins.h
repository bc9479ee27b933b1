// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Classifies the pairs of one turn and collects its joins.
 */
#ifndef lms3dTurnJoins_h
#define lms3dTurnJoins_h

#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dJoinResolver.h"

#include <cstdint>
#include <vector>

/// The flags of one turn and the pairs that are looked at again. Keeps references.
struct lms3dTurnJoins
{
  int Turn;
  std::uint8_t* Flags;
  std::vector<lms3dUncertainJoin>& UncertainJoins;
  std::vector<lms3dUncertainJoin>& Creases;
  /// Loose and Gentle pairs.
  std::vector<lms3dUncertainJoin>& Loose;

  /// Joins the neighbours in the fan whose ranges, metres, are equal (lms3dDepthStep).
  void JoinEqualRanges(
    const lms3dRangeGrid& grid, const double* ranges, const lms3dDepthStep& step);

  /// Classifies the neighbours in the fan that are not joined. `ranges`, metres, belong to the turn
  /// and have a halo of two beams.
  void ClassifyFan(const lms3dRangeGrid& grid, const double* ranges, const lms3dDepthStep& step);

  /// Classifies the beams and the same beams of the next turn.
  void ClassifyTurn(const lms3dRangeGrid& grid, const lms3dTurnClassifier& classifier);

  /// Sets the flag of a pair that lies on one surface, and lists the pair if needed.
  void Add(int beam, lms3dJoinFlag towards, lms3dDepthStep::Relation relation);

  /// Empties the lists.
  void Clear();
};

#endif
