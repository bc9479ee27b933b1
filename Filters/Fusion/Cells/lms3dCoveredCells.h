// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which cells of a mesh explain the returns of a cell.
 */
#ifndef lms3dCoveredCells_h
#define lms3dCoveredCells_h

#include "Fusion/Cells/lms3dBlockGrid.h"

#include <algorithm>
#include <cstdint>

/// Cells: from the farthest point of a cell to the centre of a cell that is 1 and 1 cells away.
inline constexpr double lms3dNearCoveredDistance = 2.1213203435596424;

/// How many cells away from a return a covered cell may be, so that the return is within the bound:
/// 2 (but not along both axes), 1 or 0. `deviation` is the return's distance from the plane; all
/// lengths are in metres.
inline int lms3dGetCoveredReach(double deviation, double cell, double maximumError)
{
  // Cells: the same for a cell that is 2 and 1 cells away.
  constexpr double FarDistance = 2.9154759474226504;
  const auto isWithin = [&](double distance)
  {
    return deviation * deviation + distance * distance * cell * cell <= maximumError * maximumError;
  };
  return isWithin(FarDistance) ? 2 : (isWithin(lms3dNearCoveredDistance) ? 1 : 0);
}

/// Whether a cell within a reach of lms3dGetCoveredReach() is covered. Only the cells of `tile`
/// count, the tile of the cell (u, v): the triangles of another tile may go without this tile being
/// made anew.
template <typename Block>
bool lms3dIsCovered(const lms3dBlockGrid<Block>& grid, const lms3dCellBox& tile, std::int32_t u,
  std::int32_t v, int reach)
{
  const std::int32_t last = std::min(v + reach, tile.Top);
  for (std::int32_t row = std::max(v - reach, tile.Bottom); row <= last; ++row)
  {
    const int width = row == v - 2 || row == v + 2 ? 1 : reach;
    if (grid.HasAny(&lms3dRegionBlock::Covered, row, std::max(u - width, tile.Left),
          std::min(u + width, tile.Right)))
    {
      return true;
    }
  }
  return false;
}

#endif
