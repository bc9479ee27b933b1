// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The blocks of a plane with guesses of the local map that joins.
 */
#ifndef lms3dGuessedBlocks_h
#define lms3dGuessedBlocks_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Passages/lms3dCutPolygon.h"

#include <cstdint>
#include <vector>

/// A polygon between beams can be kilometres long, so a search goes through the blocks that exist,
/// not through the cells of the polygon. Coordinates are cells.
class lms3dGuessedBlocks
{
public:
  explicit lms3dGuessedBlocks(const lms3dRaster& raster);

  /// Whether a cell whose centre lies in a convex polygon has Guess.
  bool HasAny(const lms3dCutPolygon& polygon, const lms3dRaster& raster) const;

  /// Clears Guess of these cells.
  void Clear(const lms3dCutPolygon& polygon, lms3dRaster& raster) const;

private:
  struct Block
  {
    std::int32_t V;
    std::int32_t U;
    int Number;

    bool operator<(const Block& other) const
    {
      return this->V != other.V ? this->V < other.V : this->U < other.U;
    }
  };

  /// The first block that is not before a place.
  std::vector<Block>::const_iterator Find(std::int32_t v, std::int32_t u) const;

  /// Calls `visit` with the number of each block that meets the polygon, and the cells of the
  /// polygon in the rows of the block. Stops, and returns false, if `visit` returns false.
  template <typename Visitor>
  bool ForStrips(const lms3dCutPolygon& polygon, const Visitor& visit) const;

  /// Row by row.
  std::vector<Block> Blocks;
};

#endif
