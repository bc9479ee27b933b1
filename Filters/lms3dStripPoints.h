// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The coordinates of a piece of two neighbouring turns, laid out for vectorized loops.
 */
#ifndef lms3dStripPoints_h
#define lms3dStripPoints_h

#include "lms3dRangeGrid.h"

#include <array>

/**
 * Some neighbouring beams of a turn and of the next. Moves from turn to turn, so that each is
 * fetched once. Its size is fixed, so that compilers see that its rows do not overlap, and small
 * enough for the nearest cache.
 */
class lms3dStripPoints
{
public:
  static constexpr int MostBeams = 64;
  using Row = std::array<double, MostBeams>;
  using Rows = std::array<Row, 3>;

  /// Keeps references. `points` are three coordinates for each vertex of the grid.
  lms3dStripPoints(const lms3dRangeGrid& grid, const double* points, int firstBeam);

  /// As many as there are, up to the ghost after the last, and fit.
  int GetNumberOfBeams() const { return this->Beams; }

  /// Makes the next turn the first of the two, and fetches `turn` for the next.
  void Fetch(int turn);

  /// Coordinates; those of some other return where there is none.
  Rows Here = {};
  Rows Next = {};

private:
  const lms3dRangeGrid& Grid;
  const double* const Points;
  const int FirstBeam;
  const int Beams;
};

#endif
