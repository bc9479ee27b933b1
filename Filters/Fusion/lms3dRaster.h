// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What scans know about a plane, cell by cell.
 */
#ifndef lms3dRaster_h
#define lms3dRaster_h

#include "Fusion/lms3dBlockGrid.h"
#include "Fusion/lms3dFusedMesh.h"

#include <cstdint>
#include <vector>

/// May are the cells where a local map has surface.
struct lms3dRasterBlock : lms3dRegionBlock
{
  /// The local map that joins has surface here.
  lms3dBits Guess = {};
  /// Here is a place between beams that all passed, without a return among them.
  lms3dBits Open = {};
  /// The region covers the cell, before its borders are straightened: now, and when the mesh was
  /// made.
  lms3dBits Shape = {};
  lms3dBits Meshed = {};

  /// The largest distance of a return from the plane, metres.
  double Deviation = 0.0;
  lms3dSightings Sightings;
  /// How well BestScan saw the block: larger is better.
  double Quality = 0.0;

  /// The tile of the plane, -1 for a new block.
  int Tile = -1;
  /// How many cells differ between Shape and Meshed.
  int Difference = 0;
  /// How many cells of creases are new since the mesh was made.
  int NewCreaseCells = 0;
  /// Whether a bit of Passed is set.
  bool HasPassed = false;
  /// Whether more returns in cells of the shape make no shape anew.
  bool IsCalm = false;
  /// Bits of lms3dRaster::Mark.
  unsigned Marks = 0;
};

class lms3dRaster : public lms3dBlockGrid<lms3dRasterBlock>
{
public:
  /// What happened to a block since the region was made.
  enum Mark : unsigned
  {
    /// The shape of the region may change.
    DIRTY = 1,
    /// A return lies here.
    SEEN = 2,
    /// The mesh does not explain what scans saw.
    STALE = 4,
    /// The local map that joins has surface here.
    GUESSED = 8,
    /// The shape of the neighbours may change, too.
    DIRTY_AROUND = 16
  };

  /// The same, but marks the blocks in which a cell of the shape changes as dirty.
  void SetAndMark(BitsOf bits, const lms3dCellStrip& strip, bool value);

  /// Sets Guess of the cells of a strip. Makes the blocks that do not exist, and marks them as
  /// guessed.
  void SetGuess(const lms3dCellStrip& strip);

  /// Adds a mark to a block.
  void SetMark(int number, Mark mark)
  {
    unsigned& marks = this->Blocks[number].Marks;
    if (marks == 0)
    {
      this->Marked.push_back(number);
    }
    marks |= mark;
  }

  /// The blocks with marks.
  const std::vector<int>& GetMarked() const { return this->Marked; }
  bool HasMark(int number, Mark mark) const { return (this->Blocks[number].Marks & mark) != 0; }
  void ClearMarks();

  /// Makes the blocks of a strip that do not exist, row by row.
  void MakeBlocks(const lms3dCellStrip& strip);

private:
  std::vector<int> Marked;
};

#endif
