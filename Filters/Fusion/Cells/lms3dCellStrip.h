// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cells of a raster in successive rows of one row of blocks.
 */
#ifndef lms3dCellStrip_h
#define lms3dCellStrip_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

///@{
/// The next whole number downwards, or upwards. Faster than the functions of the C library, which
/// are for all numbers.
inline std::int32_t lms3dGetCellOf(double place)
{
  const auto cell = static_cast<std::int32_t>(place);
  return place < cell ? cell - 1 : cell;
}

inline std::int32_t lms3dGetCellFrom(double place)
{
  return -lms3dGetCellOf(-place);
}
///@}

/// The first and the last cells of both axes.
struct lms3dCellBox
{
  std::int32_t Left;
  std::int32_t Right;
  std::int32_t Bottom;
  std::int32_t Top;
};

struct lms3dCellStrip
{
  /// The rows of a block.
  static constexpr int Size = 64;

  /// The first row.
  std::int32_t Row = 0;
  int Count = 0;
  /// The first and the last cell of each row. A row without cells has the first behind the last.
  std::array<std::int32_t, Size> First;
  std::array<std::int32_t, Size> Last;
  /// The first and the last cell of all rows.
  std::int32_t Left = std::numeric_limits<std::int32_t>::max();
  std::int32_t Right = std::numeric_limits<std::int32_t>::min();

  void Add(std::int32_t first, std::int32_t last)
  {
    this->First[this->Count] = first;
    this->Last[this->Count] = last;
    ++this->Count;
    if (first <= last)
    {
      this->Left = std::min(this->Left, first);
      this->Right = std::max(this->Right, last);
    }
  }

  void AddEmpty() { this->Add(0, -1); }
  bool IsEmpty() const { return this->Left > this->Right; }

  /// The cells of a row in a block that begins with the cell `start`, as bits.
  std::uint64_t GetBits(int row, std::int32_t start) const
  {
    // A long strip can begin or end 2^31 cells and more before or behind the block.
    const std::int64_t from = std::max<std::int64_t>(std::int64_t{ this->First[row] } - start, 0);
    const std::int64_t to =
      std::min<std::int64_t>(std::int64_t{ this->Last[row] } - start, Size - 1);
    return from > to ? 0 : (~std::uint64_t{ 0 } << from) & (~std::uint64_t{ 0 } >> (Size - 1 - to));
  }
};

/// The strip of one cell.
inline lms3dCellStrip lms3dMakeCellStrip(std::int32_t u, std::int32_t v)
{
  lms3dCellStrip strip;
  strip.Row = v;
  strip.Add(u, u);
  return strip;
}

#endif
