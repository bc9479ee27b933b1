// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Squares of 8 x 8 cells of a block, as bits of a word, row by row.
 */
#ifndef lms3dSquares_h
#define lms3dSquares_h

#include "Fusion/Cells/lms3dBlockGrid.h"

#include <cstdint>

using lms3dSquares = std::uint64_t;

/// The squares with some cells of a row.
inline lms3dSquares lms3dGetSquares(int row, std::uint64_t cells)
{
  // Bit 8 i says whether one of the eight cells from 8 i on is among them.
  cells |= cells >> 4;
  cells |= cells >> 2;
  cells |= cells >> 1;
  cells &= 0x0101010101010101U;
  // The product has these bits in its last byte.
  return (cells * 0x0102040810204080U) >> 56 << (row / 8 * 8);
}

/// The squares with some cells.
inline lms3dSquares lms3dGetSquares(const lms3dBits& cells)
{
  lms3dSquares squares = 0;
  for (int row = 0; row < 64; row += 8)
  {
    std::uint64_t together = 0;
    for (int i = 0; i < 8; ++i)
    {
      together |= cells[row + i];
    }
    squares |= lms3dGetSquares(row, together);
  }
  return squares;
}

/// The squares, in the block that is `u` and `v` blocks away, with all cells that are at most 16
/// cells away from the squares.
inline lms3dSquares lms3dGetSquaresNear(lms3dSquares squares, int u, int v)
{
  constexpr lms3dSquares First = 0x0101010101010101U;
  const lms3dSquares rows = v == 0
    ? squares | squares << 8 | squares << 16 | squares >> 8 | squares >> 16
    : (v > 0 ? squares >> 48 | squares >> 56 : squares << 48 | squares << 56);
  if (u == 0)
  {
    return rows | (rows << 1 & ~First) | (rows << 2 & ~(3 * First)) | (rows >> 1 & ~(First << 7)) |
      (rows >> 2 & ~(3 * First << 6));
  }
  return u > 0 ? (rows >> 6 & 3 * First) | (rows >> 7 & First)
               : (rows << 6 & 3 * First << 6) | (rows << 7 & First << 7);
}

/// Squares with cells that changed, by what this can do to the region of a plane.
struct lms3dChangedSquares
{
  /// Returns where the region may be: it may take disputed cells.
  lms3dSquares Returns = 0;
  /// More surface: the region may grow.
  lms3dSquares More = 0;
  /// Beams that passed, or returns that went: the region may shrink.
  lms3dSquares Less = 0;

  /// Whether they are near the block that is `u` and `v` blocks away.
  bool AreNear(int u, int v) const
  {
    return lms3dGetSquaresNear(this->Returns | this->More | this->Less, u, v) != 0;
  }
};

/// Squares of the region of a plane. A new block has not been looked at.
struct lms3dRegionSquares
{
  /// Has cells of the region.
  lms3dSquares Some = ~lms3dSquares{ 0 };
  /// Has other cells.
  lms3dSquares Gaps = ~lms3dSquares{ 0 };
  /// Has cells that would be of the region if more returns were near.
  lms3dSquares Disputed = ~lms3dSquares{ 0 };

  /// Whether changes in the block that is `u` and `v` blocks away from this one can change the
  /// region.
  bool DependOn(const lms3dChangedSquares& changes, int u, int v) const
  {
    return ((lms3dGetSquaresNear(changes.Returns, -u, -v) & this->Disputed) |
             (lms3dGetSquaresNear(changes.More, -u, -v) & this->Gaps) |
             (lms3dGetSquaresNear(changes.Less, -u, -v) & this->Some)) != 0;
  }
};

#endif
