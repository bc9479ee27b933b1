// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What scans know about a plane, cell by cell.
 */
#ifndef lms3dRaster_h
#define lms3dRaster_h

#include "Fusion/Cells/lms3dBlockGrid.h"
#include "Fusion/Cells/lms3dFusedMesh.h"
#include "Fusion/Cells/lms3dSquares.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

/// May are the cells where a local map has surface.
struct lms3dRasterBlock : lms3dRegionBlock
{
  /// The local map that joins has surface here, and no map before it has.
  lms3dBits Guess = {};
  /// Here is a place between beams that all passed, without a return among them.
  lms3dBits Open = {};
  /// A return lies here that a covered cell explains only if it is at most one cell away. Far says
  /// that only the cell itself explains a return.
  lms3dBits Halfway = {};
  /// A return lies here that the mesh explains, but that the region need not grow to.
  lms3dBits Beside = {};
  /// The region covers the cell, before its borders are straightened: now, and when the mesh was
  /// made.
  lms3dBits Shape = {};
  lms3dBits Meshed = {};

  /// What each return changes lies together in memory.
  alignas(64) lms3dSightings Sightings;
  /// Bits of lms3dRaster::Mark.
  unsigned Marks = 0;
  /// Whether all bits of May, of Shape, of Meshed, and of Covered and Touched are set. They spare
  /// most looks at the bits.
  bool IsFull = false;
  bool IsShapeFull = false;
  bool IsMeshedFull = false;
  bool IsAllCovered = false;
  /// Whether a bit of Passed, or of Open, is set.
  bool HasPassed = false;
  bool HasOpen = false;
  /// Whether the mesh has surface in cells without Shape: small holes that it closes, and bridges.
  bool HasFilled = false;
  /// Whether more returns in cells of the shape make no shape anew.
  bool IsCalm = false;
  /// How well BestScan saw the block: larger is better.
  double Quality = 0.0;
  /// What changed since lms3dMarkDependents().
  lms3dChangedSquares Changes;

  /// The region when the shape was made.
  lms3dRegionSquares Region;
  /// The numbers of the blocks around, row by row, with this block in the middle; -1 where there
  /// is none.
  std::array<int, 9> Around = { -1, -1, -1, -1, -1, -1, -1, -1, -1 };
  /// The tile of the plane, -1 for a new block.
  int Tile = -1;
  /// How many cells differ between Shape and Meshed.
  int Difference = 0;
  /// How many of them are near creases.
  int DifferenceAtCreases = 0;
  /// How many cells of creases are new since the mesh was made.
  int NewCreaseCells = 0;

  /// The smallest lms3dGetCoveredReach() of the returns in a cell.
  int GetCoveredReach(int row, int column) const
  {
    const std::uint64_t far = this->Far[row] >> column & 1U;
    const std::uint64_t halfway = this->Halfway[row] >> column & 1U;
    return 2 - static_cast<int>(far + halfway);
  }
};

template <>
void lms3dBlockGrid<lms3dRasterBlock>::Link(int number);

class lms3dRaster : public lms3dBlockGrid<lms3dRasterBlock>
{
public:
  /// What happened to a block since the region was made.
  enum Mark : unsigned
  {
    /// The block's own cells changed, or its disputed ones, so that its shape may change.
    DIRTY = 1,
    /// A return lies here.
    SEEN = 2,
    /// The mesh does not explain what scans saw.
    STALE = 4,
    /// The local map that joins has surface here.
    GUESSED = 8,
    /// The block may have Changes, or has new cells with Open.
    CHANGED = 16,
    /// The local map that joined has surface where no map before it had.
    GREW = 32
  };

  /// `memory` may be nullptr.
  explicit lms3dRaster(std::shared_ptr<lms3dBlockMemory> memory = nullptr)
    : lms3dBlockGrid(std::move(memory))
  {
  }

  /// Takes all blocks out.
  void Clear() { *this = lms3dRaster(this->Blocks.get_allocator().GetMemory()); }

  /// Sets Must of a cell of a block.
  void SetReturn(int number, int u, int v)
  {
    std::uint64_t& word = this->Blocks[number].Must[v];
    const std::uint64_t bit = std::uint64_t{ 1 } << u;
    if ((word & bit) == 0)
    {
      word |= bit;
      this->NoteReturn(number, v, bit);
    }
  }

  /// Sets Passed of a cell of a block.
  void Pass(int number, int u, int v);

  /// Sets Open of the cells of a strip that lie in blocks. Marks blocks as stale in which this
  /// opens a hole that the mesh closes.
  void Open(const lms3dCellStrip& strip);

  /// Clears Must and Beside of the cells of a strip that lie in blocks. Marks blocks as stale in
  /// which a facet loses its return.
  void Forget(const lms3dCellStrip& strip);

  /// Whether Forget() has ever cleared a bit.
  bool HasForgotten() const { return this->Forgot; }

  /// Whether a cell may have Guess.
  bool MayHaveGuess() const { return this->HasGuess; }
  void ForgetGuesses() { this->HasGuess = false; }

  /// Whether all cells of a box lie in blocks and have May or Guess.
  bool HasMayOrGuess(const lms3dCellBox& box) const;

  /// Sets May of a block where Guess is set, and clears Guess. Marks the block if it grew.
  void AcceptGuess(int number);

  /// Sets Guess of the cells of a strip without May. Makes the blocks that do not exist. Marks
  /// blocks with Guess as guessed.
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
  using ChangeOf = lms3dSquares lms3dChangedSquares::*;

  /// Notes what a new return in a cell can change.
  void NoteReturn(int number, int row, std::uint64_t bit);

  /// Adds the squares of cells of a row to the Changes of a block.
  void AddChanges(int number, ChangeOf change, int row, std::uint64_t cells);
  template <typename Visitor>
  void ForWords(const lms3dCellStrip& strip, const Visitor& visit);

  std::vector<int> Marked;
  /// Whether a cell may have Guess.
  bool HasGuess = false;
  bool Forgot = false;
};

#endif
