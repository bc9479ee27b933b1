// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes triangles of neighbouring returns that lie on one surface.
 */
#ifndef lms3dGridMesher_h
#define lms3dGridMesher_h

#include "LocalMap/Grid/lms3dGridPoints.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <cstdint>
#include <vector>

/**
 * Divides each cell of the grid into two triangles along its shorter diagonal, and makes one
 * triangle of each cell at a pole. A triangle exists only if all its sides along the grid (two;
 * three at a pole) join returns of one surface.
 *
 * The corners of a cell are (turn, beam), (turn + 1, beam), (turn + 1, beam + 1), (turn, beam + 1),
 * in this order. It is counter-clockwise as the sensor sees it if angles grow from beam to beam and
 * from turn to turn. A triangle has the number of the corner at which its sides along the grid
 * meet.
 */
class lms3dGridMesher
{
public:
  /// Decides which triangles exist. Uses the threads of the calling TBB arena.
  void SelectTriangles(
    const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const lms3dGridPoints& points);

  /// The cells of a turn; each belongs to its corner 0. Bit i is set if triangle i exists. Turns -1
  /// to the number of turns, and beams from -1, can be read.
  const std::uint8_t* GetCells(int turn) const { return this->Cells.GetRow(turn); }

  std::int64_t GetNumberOfTriangles() const { return this->FirstTriangles.back(); }

  /// Writes three vertices for each triangle, ordered by turn, then by beam. Triangles face the
  /// sensor or, if lms3dScanGeometry::IsMirrored(), away from it. Uses the threads of the calling
  /// TBB arena.
  void FillTriangles(const lms3dRangeGrid& grid, std::int32_t* vertices) const;

private:
  lms3dPaddedGrid<std::uint8_t> Cells{ 0 };
  /// The first triangle of each turn, then the number of all triangles.
  std::vector<std::int64_t> FirstTriangles;
};

#endif
