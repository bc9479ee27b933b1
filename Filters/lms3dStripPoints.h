// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The coordinates of two neighbouring turns, laid out for vectorized loops.
 */
#ifndef lms3dStripPoints_h
#define lms3dStripPoints_h

#include "lms3dRangeGrid.h"

#include <array>
#include <cstdint>
#include <vector>

/// Moves over the strips between a turn and the next, one after the other, so that each turn is
/// fetched once.
class lms3dStripPoints
{
public:
  /// For each beam of a turn a coordinate; that of some other return where there is none.
  using Turn = std::array<std::vector<double>, 3>;

  /// Starts before the strip of `firstTurn`. Keeps references.
  lms3dStripPoints(const lms3dRangeGrid& grid, const double* points, int firstTurn);

  /// To the first strip, then always to the next.
  void MoveTo(int turn);

  const Turn& GetHere() const { return this->Here; }
  const Turn& GetNext() const { return this->Next; }

  /// Tells for each cell whether the diagonal from corner 0 to corner 2 is not the longer one.
  void FindShorterDiagonals(int cells, std::uint8_t* areShorter) const;

private:
  void Fetch(int turn, Turn& out) const;

  const lms3dRangeGrid& Grid;
  const double* const Points;
  Turn Here;
  Turn Next;
};

#endif
