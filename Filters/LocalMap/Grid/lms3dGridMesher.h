// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins neighbouring returns by triangles where they lie on one surface.
 */
#ifndef lms3dGridMesher_h
#define lms3dGridMesher_h

#include "LocalMap/Grid/lms3dGridPoints.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <cstdint>
#include <vector>

/**
 * Two triangles for each cell of the grid, along its shorter diagonal, one for each cell at a pole.
 * A triangle is made where its sides along the grid, two and at a pole three, join returns of one
 * surface.
 *
 * The corners of a cell are numbered counter-clockwise as the sensor sees them where angles grow
 * from beam to beam and from turn to turn: (turn, beam), (turn + 1, beam), (turn + 1, beam + 1),
 * (turn, beam + 1). A triangle goes by the corner at which its sides along the grid meet.
 */
class lms3dGridMesher
{
public:
  /// Uses the threads of the calling TBB arena, as FillTriangles does.
  void ChooseTriangles(
    const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const lms3dGridPoints& points);

  /// For each beam of a turn the cell that begins there: bit i is set where it has the triangle of
  /// corner i. Turns -1 to the number of turns and beams from -1 may be asked for.
  const std::uint8_t* GetCells(int turn) const { return this->Cells.GetRow(turn); }

  std::int64_t GetNumberOfTriangles() const { return this->FirstTriangles.back(); }

  /// Writes the vertices of the triangles, ordered by turn, then beam. The triangles face the sensor
  /// or, of a scan that lms3dScanGeometry::IsMirrored(), away from it.
  void FillTriangles(const lms3dRangeGrid& grid, std::int32_t* vertices) const;

private:
  lms3dPaddedGrid<std::uint8_t> Cells{ 0 };
  /// Of each turn, and their number at the end.
  std::vector<std::int64_t> FirstTriangles;
};

#endif
