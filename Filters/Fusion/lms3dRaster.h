// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What scans know about a plane, cell by cell, in blocks that exist only where something was seen.
 */
#ifndef lms3dRaster_h
#define lms3dRaster_h

#include "Fusion/lms3dBlockIndex.h"
#include "Fusion/lms3dCellStrip.h"
#include "Fusion/lms3dFusedMesh.h"

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

/// The bits of 64 x 64 cells, one word for each row.
using lms3dBits = std::array<std::uint64_t, 64>;

struct lms3dRasterBlock
{
  /// The numbers of the block along both axes.
  std::int32_t U;
  std::int32_t V;

  /// A local map has surface here.
  lms3dBits May = {};
  /// The local map that joins has surface here.
  lms3dBits Guess = {};
  /// A return lies here.
  lms3dBits Must = {};
  /// A beam passed here.
  lms3dBits Passed = {};
  /// Here is a place between beams that all passed, without a return among them.
  lms3dBits Open = {};
  /// A triangle of the mesh covers the centre of the cell.
  lms3dBits Covered = {};
  /// A triangle of the mesh touches the cell.
  lms3dBits Touched = {};
  /// The region covers the cell, before its borders are straightened: now, and when the mesh was made.
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
  /// Whether more returns in cells of the shape change no shape.
  bool IsCalm = false;
  /// Bits of lms3dRaster::Mark.
  unsigned Marks = 0;
};

/// Coordinates are cells.
class lms3dRaster
{
public:
  static constexpr int Size = 64;
  using BitsOf = lms3dBits lms3dRasterBlock::*;

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

  int GetNumberOfBlocks() const { return static_cast<int>(this->Blocks.size()); }
  lms3dRasterBlock& GetBlock(int number) { return this->Blocks[number]; }
  const lms3dRasterBlock& GetBlock(int number) const { return this->Blocks[number]; }

  /// The number of a block, -1 if there is none.
  int Find(std::int32_t u, std::int32_t v) const { return this->Numbers.Find(u, v); }
  /// The same, but makes the block if there is none. Successive calls for one block are quick.
  int Make(std::int32_t u, std::int32_t v)
  {
    if (this->LastMade < 0 || this->Blocks[this->LastMade].U != u ||
      this->Blocks[this->LastMade].V != v)
    {
      this->LastMade = this->FindOrMake(u, v);
    }
    return this->LastMade;
  }

  static std::int32_t GetBlockOf(std::int32_t cell) { return cell >> 6; }
  static int GetPlaceOf(std::int32_t cell) { return cell & 63; }

  bool Has(BitsOf bits, std::int32_t u, std::int32_t v) const;

  /// Returns whether a cell from `first` to `last` of a row has the bit.
  bool HasAny(BitsOf bits, std::int32_t row, std::int32_t first, std::int32_t last) const;

  /// Returns whether a cell of a strip has the bit.
  bool HasAny(BitsOf bits, const lms3dCellStrip& strip) const;

  /// Returns whether a cell of a box has the bit.
  bool HasAny(BitsOf bits, const lms3dCellBox& box) const;

  /// Returns whether all cells of a box that lie in blocks have the bit.
  bool HasAll(BitsOf bits, const lms3dCellBox& box) const;

  /// Returns whether all cells of a box lie in blocks.
  bool HasBlocks(const lms3dCellBox& box) const;

  /// Returns whether all cells of a strip lie in blocks.
  bool HasBlocks(const lms3dCellStrip& strip) const;

  /// Sets or clears a bit of the cells of a strip that lie in blocks.
  void Set(BitsOf bits, const lms3dCellStrip& strip, bool value);

  /// The same, but marks the blocks in which a cell of the shape changes as dirty.
  void SetAndMark(BitsOf bits, const lms3dCellStrip& strip, bool value);

  /// Sets Guess of the cells of a strip. Makes the blocks that do not exist, and marks them as guessed.
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

  /// Sets or clears a bit of cells of a row. Blocks are made if `makesBlocks`; other cells without a block stay.
  /// Calls `touch` with the number of each block in which a bit changed.
  template <typename Visitor>
  void SetRow(BitsOf bits, std::int32_t row, std::int32_t first, std::int32_t last, bool value,
    bool makesBlocks, const Visitor& touch)
  {
    for (std::int32_t u = GetBlockOf(first); u <= GetBlockOf(last); ++u)
    {
      const std::int32_t v = GetBlockOf(row);
      const int number = makesBlocks ? this->Make(u, v) : this->Find(u, v);
      if (number < 0)
      {
        continue;
      }
      std::uint64_t& word = (this->Blocks[number].*bits)[GetPlaceOf(row)];
      const std::uint64_t mask = GetMask(u, first, last);
      const std::uint64_t changed = value ? word | mask : word & ~mask;
      if (changed != word)
      {
        word = changed;
        touch(number);
      }
    }
  }

private:
  int FindOrMake(std::int32_t u, std::int32_t v);

  /// The bits of cells from `first` to `last` in a block.
  static std::uint64_t GetMask(std::int32_t block, std::int32_t first, std::int32_t last)
  {
    const int from = GetBlockOf(first) == block ? GetPlaceOf(first) : 0;
    const int to = GetBlockOf(last) == block ? GetPlaceOf(last) : Size - 1;
    return (~std::uint64_t{ 0 } << from) & (~std::uint64_t{ 0 } >> (Size - 1 - to));
  }

  /// Blocks stay where they are in memory when others are made.
  std::deque<lms3dRasterBlock> Blocks;
  lms3dBlockIndex Numbers;
  std::vector<int> Marked;
  /// The block of the last call of Make(), -1 if there is none.
  int LastMade = -1;
};

#endif
