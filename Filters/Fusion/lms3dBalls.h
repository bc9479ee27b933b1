// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the cells that are nearer to some cells than to others.
 */
#ifndef lms3dBalls_h
#define lms3dBalls_h

#include "Fusion/lms3dRaster.h"

#include <array>
#include <cstdint>
#include <functional>

/// A block with the half of each neighbour that is next to it.
class lms3dBlockWindow
{
public:
  /// The cells beyond the block on each side.
  static constexpr int Margin = 32;
  /// Cells: the largest radius of a ball.
  static constexpr int LargestRadius = (Margin - 1) / 2;

  /// The cells that `getBits`, a member or a function, returns for a block. The blocks that a grid
  /// does not have are empty.
  template <typename Block, typename Getter>
  lms3dBlockWindow(
    const lms3dBlockGrid<Block>& grid, const lms3dRegionBlock& block, const Getter& getBits)
  {
    for (int v = -1; v <= 1; ++v)
    {
      for (int u = -1; u <= 1; ++u)
      {
        const int number = grid.Find(block.U + u, block.V + v);
        if (number >= 0)
        {
          this->Add(u, v, std::invoke(getBits, grid.GetBlock(number)));
        }
      }
    }
  }

  bool IsEmpty() const { return this->HasNone; }

  /// The distance along the longer axis of the cell nearest to a cell of the block, at most Margin.
  /// The distance to the cell itself is 0.
  int GetDistance(int u, int v) const;

  /// The cells of the block that have a cell of the window at most LargestRadius away along both
  /// axes.
  lms3dBits GetCellsNear() const;

private:
  void Add(int u, int v, const lms3dBits& bits);

  /// The cells of a row from 31 before a cell to 32 behind it. Bit 31 is the cell itself.
  std::uint64_t GetWord(int u, int row) const;

  /// The words of the blocks on the left, in the middle and on the right.
  std::array<std::array<std::uint64_t, 3>, lms3dRaster::Size + 2 * Margin> Rows = {};
  bool HasNone = true;
};

/// The balls around the cells of a block that are nearer to them than to any cell of a window.
/// Cells farther than 15 cells are in no ball.
class lms3dBalls
{
public:
  /// The balls around the cells of `centres`.
  lms3dBalls(const lms3dBits& centres, const lms3dBlockWindow& others);

  /// Calls `visit` with each row from -16 to 79 that has cells, and with the words of the blocks on
  /// the left, in the middle and on the right.
  template <typename Visitor>
  void ForRows(const Visitor& visit) const
  {
    for (int row = 0; row < static_cast<int>(this->Rows.size()); ++row)
    {
      if ((this->Rows[row][0] | this->Rows[row][1] | this->Rows[row][2]) != 0)
      {
        visit(row - Largest - 1, this->Rows[row]);
      }
    }
  }

private:
  static constexpr int Largest = lms3dBlockWindow::LargestRadius;

  void Add(int u, int v, int radius);

  std::array<std::array<std::uint64_t, 3>, lms3dRaster::Size + 2 * (Largest + 1)> Rows = {};
};

#endif
