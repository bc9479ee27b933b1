// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane that are near both returns and beams that passed.
 */
#ifndef lms3dDisputedCells_h
#define lms3dDisputedCells_h

#include "Fusion/lms3dRaster.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class lms3dBalls;

/**
 * A disputed cell belongs to the nearer of returns and beams that passed. Around returns in cells
 * that are open lie balls that are nearer to them than to any beam that passed; they give cells
 * back. Around beams that passed where the plane may have surface lie balls that are nearer to them
 * than to any return; they take cells out (lms3dBalls).
 *
 * The balls of a block reach 15 cells into its neighbours, and depend on cells that are 31 cells
 * away. So they are kept, and made anew only where such cells changed.
 */
class lms3dDisputedCells
{
public:
  /// Makes the balls anew of the blocks that are marked as disputed, and of those that are near
  /// blocks marked as around. Marks blocks whose balls or disputed cells change as dirty.
  void Update(lms3dRaster& raster);

  /// Gives cells of a block with May back, then takes cells out.
  void Divide(const lms3dRaster& raster, int number, lms3dBits& cells) const;

private:
  /// Cells of a block and of its neighbours, from a first row on: the words of the blocks on the
  /// left, in the middle and on the right. Row 0 is the first row of the block.
  class Cells
  {
  public:
    Cells() = default;
    explicit Cells(const lms3dBalls& balls);

    bool IsEmpty() const { return this->Rows.empty(); }
    /// A row of the block that is `u` and `v` blocks away.
    std::uint64_t Get(int u, int v, int row) const
    {
      const int place = row + v * lms3dRaster::Size - this->First;
      return place >= 0 && place < static_cast<int>(this->Rows.size()) ? this->Rows[place][u + 1]
                                                                       : 0;
    }

  private:
    int First = 0;
    std::vector<std::array<std::uint64_t, 3>> Rows;
  };

  /// What the balls of a block give and take.
  struct Shares
  {
    Cells Given;
    Cells Taken;
  };

  struct Block
  {
    /// The blocks around it, row by row, with itself in the middle; -1 where there is none.
    std::array<int, 9> Around = { -1, -1, -1, -1, -1, -1, -1, -1, -1 };
    /// Whether it has cells that may be centres of balls.
    bool HasCentres = false;
    bool IsListed = false;
    /// nullptr without balls.
    std::unique_ptr<Shares> Kept;
  };

  void AddBlocks(const lms3dRaster& raster);
  std::vector<int> FindBlocks(const lms3dRaster& raster);
  static Shares MakeShares(const lms3dRaster& raster, const lms3dRasterBlock& block);
  void MarkChanges(const Shares& before, const Shares& now, int number, lms3dRaster& raster) const;

  std::vector<Block> Blocks;
};

#endif
