// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The parts of the blocks of a plane that are joined to a return.
 */
#ifndef lms3dReachedParts_h
#define lms3dReachedParts_h

#include "Fusion/Cells/lms3dBlockParts.h"
#include "Fusion/Cells/lms3dRaster.h"

#include <array>
#include <cstdint>
#include <vector>

/// Keeps how the parts of a block touch its sides. Blocks have the numbers of the raster.
class lms3dReachedParts
{
public:
  /// Links new blocks with their neighbours.
  void AddBlocks(const lms3dRaster& raster);

  /// Replaces the parts of a block. `returns` are the cells with returns that reach a part.
  void Set(int number, const lms3dBlockParts& parts, const lms3dBits& returns);

  /// Finds out which parts are joined to a return. Returns the blocks with parts that were joined
  /// before and are not any more, or the reverse, in order.
  std::vector<int> Update();

  bool IsReached(int number, int part) const { return this->Blocks[number].Parts[part].IsReached; }

  /// Whether all parts of a block have returns of their own.
  bool HaveReturns(int number) const;

private:
  /// The cells at the sides of a block: left, right, bottom, top.
  using Sides = std::array<std::uint64_t, 4>;

  struct Part
  {
    Sides Cells;
    bool HasReturn;
    bool IsReached;
  };

  struct Block
  {
    int Right = -1;
    int Above = -1;
    /// The number of the first part when all parts are numbered.
    int FirstPart = 0;
    std::vector<Part> Parts;
  };

  void Connect(std::vector<int>& links) const;
  /// Calls `visit` with the number of the block, that of the part among all parts, and the part.
  template <typename Visitor>
  void ForParts(const Visitor& visit);

  std::vector<Block> Blocks;
  /// Whether parts changed since the last update.
  bool HasChanged = false;
};

#endif
