// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the squares of cells that say which regions may change.
 */
#include "Fusion/Cells/lms3dSquares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace
{
constexpr int Size = 8;
constexpr int Reach = 16;

/// Whether two ranges of cells, of a square and of another one `blocks` blocks away, are at most 16
/// cells apart.
bool AreNear(int square, int other, int blocks)
{
  const int first = square * Size;
  const int second = other * Size + 64 * blocks;
  return std::max(first, second) - (std::min(first, second) + Size - 1) <= Reach;
}

lms3dSquares GetSquaresOneByOne(int square, int u, int v)
{
  lms3dSquares near = 0;
  for (int other = 0; other < 64; ++other)
  {
    if (AreNear(square % Size, other % Size, u) && AreNear(square / Size, other / Size, v))
    {
      near |= lms3dSquares{ 1 } << other;
    }
  }
  return near;
}
} // namespace

TEST(LMS3DSquares, AreOfTheirCells)
{
  for (int row = 0; row < 64; ++row)
  {
    for (int place = 0; place < 64; ++place)
    {
      lms3dBits cells = {};
      cells[row] = std::uint64_t{ 1 } << place;
      const lms3dSquares expected = lms3dSquares{ 1 } << (row / Size * Size + place / Size);
      EXPECT_EQ(lms3dGetSquares(row, cells[row]), expected);
      EXPECT_EQ(lms3dGetSquares(cells), expected);
    }
  }
}

TEST(LMS3DSquares, HaveNearOnesInAllBlocksAround)
{
  for (int square = 0; square < 64; ++square)
  {
    for (int v = -1; v <= 1; ++v)
    {
      for (int u = -1; u <= 1; ++u)
      {
        EXPECT_EQ(
          lms3dGetSquaresNear(lms3dSquares{ 1 } << square, u, v), GetSquaresOneByOne(square, u, v))
          << square << ": " << u << " " << v;
      }
    }
  }
}
