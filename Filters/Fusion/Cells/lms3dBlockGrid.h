// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cells of a plane with bits, in blocks that exist only where something was seen.
 */
#ifndef lms3dBlockGrid_h
#define lms3dBlockGrid_h

#include "Casting/lms3dBitMask.h"
#include "Fusion/Cells/lms3dBlockIndex.h"
#include "Fusion/Cells/lms3dBlockMemory.h"
#include "Fusion/Cells/lms3dCellStrip.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

/// The bits of 64 x 64 cells, one word for each row.
using lms3dBits = std::array<std::uint64_t, 64>;

/// Bits with one word for all rows.
constexpr lms3dBits lms3dMakeBits(std::uint64_t word)
{
  lms3dBits bits = {};
  for (std::uint64_t& row : bits)
  {
    row = word;
  }
  return bits;
}

inline constexpr lms3dBits lms3dNoBits = lms3dMakeBits(0);
inline constexpr lms3dBits lms3dAllBits = lms3dMakeBits(~std::uint64_t{ 0 });

/// Whether all bits are set.
inline bool lms3dAreAllSet(const lms3dBits& bits)
{
  std::uint64_t all = ~std::uint64_t{ 0 };
  for (const std::uint64_t word : bits)
  {
    all &= word;
  }
  return all == ~std::uint64_t{ 0 };
}

/// What a region is made of.
struct lms3dRegionBlock
{
  /// The numbers of the block along both axes.
  std::int32_t U;
  std::int32_t V;

  /// The plane may have surface here.
  lms3dBits May = {};
  /// A return lies here.
  lms3dBits Must = {};
  /// A return lies here that is so far from the plane that a border must not cut it off.
  lms3dBits Far = {};
  /// A beam passed here.
  lms3dBits Passed = {};
  /// A triangle of the mesh covers the centre of the cell.
  lms3dBits Covered = {};
  /// A triangle of the mesh touches the cell.
  lms3dBits Touched = {};
};

/// Coordinates are cells. `Block` has the members of lms3dRegionBlock.
template <typename Block>
class lms3dBlockGrid
{
public:
  static constexpr int Size = 64;
  using BitsOf = lms3dBits Block::*;

  /// `memory` may be nullptr.
  explicit lms3dBlockGrid(std::shared_ptr<lms3dBlockMemory> memory = nullptr)
    : Blocks(lms3dBlockAllocator<Block>(std::move(memory)))
  {
  }

  int GetNumberOfBlocks() const { return static_cast<int>(this->Blocks.size()); }
  Block& GetBlock(int number) { return this->Blocks[number]; }
  const Block& GetBlock(int number) const { return this->Blocks[number]; }

  /// The number of a block, -1 if there is none.
  int Find(std::int32_t u, std::int32_t v) const { return this->Numbers.Find(u, v); }
  /// The same, but makes the block if there is none. Successive calls for one block are quick.
  int Make(std::int32_t u, std::int32_t v)
  {
    if (this->LastMade < 0 || this->LastU != u || this->LastV != v)
    {
      this->LastMade = this->FindOrMake(u, v);
      this->LastU = u;
      this->LastV = v;
    }
    return this->LastMade;
  }

  static std::int32_t GetBlockOf(std::int32_t cell) { return cell >> 6; }
  static int GetPlaceOf(std::int32_t cell) { return cell & 63; }

  bool Has(BitsOf bits, std::int32_t u, std::int32_t v) const
  {
    const int number = this->Find(GetBlockOf(u), GetBlockOf(v));
    return number >= 0 && ((this->Blocks[number].*bits)[GetPlaceOf(v)] >> GetPlaceOf(u) & 1U) != 0;
  }

  /// Returns whether a cell from `first` to `last` of a row has the bit.
  bool HasAny(BitsOf bits, std::int32_t row, std::int32_t first, std::int32_t last) const;

  /// Returns whether a cell of a strip has the bit.
  bool HasAny(BitsOf bits, const lms3dCellStrip& strip) const;

  /// Returns whether a cell of a box has the bit.
  bool HasAny(BitsOf bits, const lms3dCellBox& box) const
  {
    return this->HasDifferent(bits, box, 0);
  }

  /// Returns whether all cells of a box that lie in blocks have the bit.
  bool HasAll(BitsOf bits, const lms3dCellBox& box) const
  {
    return !this->HasDifferent(bits, box, ~std::uint64_t{ 0 });
  }

  /// The same for a box that lies in one block.
  bool HasAll(BitsOf bits, int number, const lms3dCellBox& box) const
  {
    const lms3dBits& words = this->Blocks[number].*bits;
    const std::uint64_t mask = GetMask(GetBlockOf(box.Left), box.Left, box.Right);
    std::uint64_t missing = 0;
    for (int row = GetPlaceOf(box.Bottom); row <= GetPlaceOf(box.Top); ++row)
    {
      missing |= ~words[row] & mask;
    }
    return missing == 0;
  }

  /// Calls `visit` with both coordinates of the cells of a strip that have the bit, row by row.
  /// Stops, and returns false, if `visit` returns false.
  template <typename Visitor>
  bool ForCells(BitsOf bits, const lms3dCellStrip& strip, const Visitor& visit) const;

  /// Returns whether all cells of a box lie in blocks.
  bool HasBlocks(const lms3dCellBox& box) const;

  /// Returns whether all cells of a strip lie in blocks.
  bool HasBlocks(const lms3dCellStrip& strip) const;

  /// Sets or clears a bit of the cells of a strip that lie in blocks.
  void Set(BitsOf bits, const lms3dCellStrip& strip, bool value);

  /// Sets or clears a bit of cells of a row. Blocks are made if `makesBlocks`; other cells without
  /// a block stay. Calls `touch` with the number of each block in which a bit changed.
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

protected:
  /// Lets a new block know the blocks around it, and the reverse, if blocks keep these: then the
  /// header of the block has a specialization.
  void Link(int /* number */) {}
  int FindOrMake(std::int32_t u, std::int32_t v);

  /// Returns whether a cell of a box lies in a block and differs from its bit in `word`.
  bool HasDifferent(BitsOf bits, const lms3dCellBox& box, std::uint64_t word) const;

  /// The bits of cells from `first` to `last` in a block.
  static std::uint64_t GetMask(std::int32_t block, std::int32_t first, std::int32_t last)
  {
    const int from = GetBlockOf(first) == block ? GetPlaceOf(first) : 0;
    const int to = GetBlockOf(last) == block ? GetPlaceOf(last) : Size - 1;
    return (~std::uint64_t{ 0 } << from) & (~std::uint64_t{ 0 } >> (Size - 1 - to));
  }

  /// Blocks stay where they are in memory when others are made.
  std::deque<Block, lms3dBlockAllocator<Block>> Blocks;
  lms3dBlockIndex Numbers;
  /// The block of the last call of Make(), -1 if there is none.
  int LastMade = -1;
  std::int32_t LastU = 0;
  std::int32_t LastV = 0;
};

template <typename Block>
template <typename Visitor>
bool lms3dBlockGrid<Block>::ForCells(
  BitsOf bits, const lms3dCellStrip& strip, const Visitor& visit) const
{
  const std::int32_t v = GetBlockOf(strip.Row);
  for (int i = 0; i < strip.Count; ++i)
  {
    if (strip.First[i] > strip.Last[i])
    {
      continue;
    }
    const std::int32_t last = GetBlockOf(strip.Last[i]);
    for (std::int32_t u = GetBlockOf(strip.First[i]); u <= last; ++u)
    {
      const int number = this->Find(u, v);
      std::uint64_t cells = number < 0
        ? 0
        : (this->Blocks[number].*bits)[GetPlaceOf(strip.Row) + i] & strip.GetBits(i, u * Size);
      for (; cells != 0; cells &= cells - 1)
      {
        if (!visit(u * Size + lms3dGetFirstBit(cells), strip.Row + i))
        {
          return false;
        }
      }
    }
  }
  return true;
}

using lms3dRegion = lms3dBlockGrid<lms3dRegionBlock>;

#endif
