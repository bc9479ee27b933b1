// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a block and of those around it, all at once.
 */
#ifndef lms3dCellWindow_h
#define lms3dCellWindow_h

#include "Fusion/Cells/lms3dBlockGrid.h"

#include <array>
#include <cstdint>

/// A block with the cells around it: those at most Reach cells away are right after Widen(), Race()
/// or Close(), if those beyond the window are not known.
class lms3dCellWindow
{
public:
  static constexpr int Size = 64;
  static constexpr int Reach = 16;
  static constexpr int Rows = Size + 2 * Reach;
  using Column = std::array<std::uint64_t, Rows>;

  /// Sets the cells of the block that is `u` and `v` blocks away.
  void Add(int u, int v, const lms3dBits& bits);

  /// The block in the middle.
  lms3dBits GetMiddle() const;

  bool HasCells() const;

  /// Adds the eight neighbours of each cell.
  void Widen();

  /// Returns all cells that Race() can give to these cells, and some more.
  lms3dCellWindow GetReachOfRace() const;

  /// Widens two sides, which share no cell, step by step until they meet. A cell that both reach
  /// with one step stays without a side. Four neighbours and eight take turns: octagons are nearly
  /// round. Stops as soon as each cell of `undecided` has a side.
  static void Race(lms3dCellWindow undecided, lms3dCellWindow& first, lms3dCellWindow& second);

  /// Adds the cells between cells, in gaps that are narrower than 16 cells along an axis.
  void Close();

  lms3dCellWindow& operator|=(const lms3dCellWindow& other);
  lms3dCellWindow& operator&=(const lms3dCellWindow& other);
  /// Takes the cells of another window out.
  lms3dCellWindow& operator-=(const lms3dCellWindow& other);

private:
  void Invert();

  /// 32 cells beside the block, then its first half; its second half, then 32 cells beside it.
  Column Left = {};
  Column Right = {};
};

#endif
