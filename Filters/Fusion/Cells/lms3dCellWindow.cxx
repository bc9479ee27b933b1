// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dCellWindow.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace
{
using Column = lms3dCellWindow::Column;
constexpr int Rows = lms3dCellWindow::Rows;
constexpr int Half = lms3dCellWindow::Size / 2;
// Shifts are no larger. So the rows of a padded column stay in line with the memory of vectors.
constexpr int Padding = 8;

/// A column between rows without cells.
struct PaddedColumn
{
  alignas(64) std::array<std::uint64_t, Rows + 2 * Padding> Words = {};
};

inline std::uint64_t WidenLeft(std::uint64_t left, std::uint64_t right, int shift)
{
  return left | left << shift | left >> shift | right << (lms3dCellWindow::Size - shift);
}

inline std::uint64_t WidenRight(std::uint64_t left, std::uint64_t right, int shift)
{
  return right | right << shift | right >> shift | left >> (lms3dCellWindow::Size - shift);
}

inline std::uint64_t GetBeside(const PaddedColumn& column, int row, int shift)
{
  return column.Words[row + Padding - shift] | column.Words[row + Padding + shift];
}

// Adds the cells of three by three that are `shift` cells apart.
LMS3D_WIDE_LOOPS void WidenBoth(int shift, Column& left, Column& right)
{
  PaddedColumn l;
  PaddedColumn r;
  for (int row = 0; row < Rows; ++row)
  {
    l.Words[row + Padding] = WidenLeft(left[row], right[row], shift);
    r.Words[row + Padding] = WidenRight(left[row], right[row], shift);
  }
  for (int row = 0; row < Rows; ++row)
  {
    left[row] = l.Words[row + Padding] | GetBeside(l, row, shift);
    right[row] = r.Words[row + Padding] | GetBeside(r, row, shift);
  }
}

/// The columns of a window, wider by a cell along the rows, and what is added to the rows beside.
struct WideColumns
{
  std::array<PaddedColumn, 2> Wide;
  std::array<PaddedColumn, 2> Beside;

  std::uint64_t Get(int column, int row) const
  {
    return this->Wide[column].Words[row + Padding] | GetBeside(this->Beside[column], row, 1);
  }
};

LMS3D_WIDE_LOOPS void Prepare(
  bool hasEight, const Column& left, const Column& right, WideColumns& columns)
{
  const std::uint64_t corners = hasEight ? ~std::uint64_t{ 0 } : 0;
  for (int row = 0; row < Rows; ++row)
  {
    const std::uint64_t l = WidenLeft(left[row], right[row], 1);
    const std::uint64_t r = WidenRight(left[row], right[row], 1);
    columns.Wide[0].Words[row + Padding] = l;
    columns.Wide[1].Words[row + Padding] = r;
    columns.Beside[0].Words[row + Padding] = left[row] | (l & corners);
    columns.Beside[1].Words[row + Padding] = right[row] | (r & corners);
  }
}

// Gives cells that only one side reaches to this side. Returns whether there are any.
LMS3D_WIDE_LOOPS bool GiveCells(int column, const WideColumns& wideFirst,
  const WideColumns& wideSecond, Column& first, Column& second)
{
  std::uint64_t changed = 0;
  for (int row = 0; row < Rows; ++row)
  {
    const std::uint64_t a = wideFirst.Get(column, row);
    const std::uint64_t b = wideSecond.Get(column, row);
    changed |= (a & ~b & ~first[row]) | (b & ~a & ~second[row]);
    first[row] |= a & ~b;
    second[row] |= b & ~a;
  }
  return changed != 0;
}

LMS3D_WIDE_LOOPS void Unite(const Column& other, Column& column)
{
  for (int row = 0; row < Rows; ++row)
  {
    column[row] |= other[row];
  }
}

LMS3D_WIDE_LOOPS void Intersect(const Column& other, Column& column)
{
  for (int row = 0; row < Rows; ++row)
  {
    column[row] &= other[row];
  }
}

LMS3D_WIDE_LOOPS void Subtract(const Column& other, Column& column)
{
  for (int row = 0; row < Rows; ++row)
  {
    column[row] &= ~other[row];
  }
}

// Adds half of each word: its second half to the first half of a row, or the reverse.
LMS3D_WIDE_LOOPS void AddShifted(
  const std::uint64_t* words, int count, bool isSecond, std::uint64_t* rows)
{
  const int right = isSecond ? Half : 0;
  const int left = Half - right;
  for (int row = 0; row < count; ++row)
  {
    rows[row] |= words[row] >> right << left;
  }
}

LMS3D_WIDE_LOOPS bool HasBits(const Column& column)
{
  std::uint64_t all = 0;
  for (int row = 0; row < Rows; ++row)
  {
    all |= column[row];
  }
  return all != 0;
}
} // namespace

void lms3dCellWindow::Add(int u, int v, const lms3dBits& bits)
{
  const int first = std::max(v * Size, -Reach);
  const int count = std::min((v + 1) * Size, Size + Reach) - first;
  const std::uint64_t* const words = bits.data() + first - v * Size;
  if (u <= 0)
  {
    AddShifted(words, count, u < 0, this->Left.data() + first + Reach);
  }
  if (u >= 0)
  {
    AddShifted(words, count, u == 0, this->Right.data() + first + Reach);
  }
}

lms3dBits lms3dCellWindow::GetMiddle() const
{
  lms3dBits bits;
  for (int row = 0; row < Size; ++row)
  {
    bits[row] = this->Left[row + Reach] >> Half | this->Right[row + Reach] << Half;
  }
  return bits;
}

void lms3dCellWindow::Widen()
{
  WidenBoth(1, this->Left, this->Right);
}

// Shifts that add up to the number of steps.
lms3dCellWindow lms3dCellWindow::GetReachOfRace() const
{
  static_assert(1 + 2 + 4 + 8 == Reach - 1);
  lms3dCellWindow reached = *this;
  for (const int shift : { 1, 2, 4, 8 })
  {
    WidenBoth(shift, reached.Left, reached.Right);
  }
  return reached;
}

// A step without a change of either kind is the last one.
void lms3dCellWindow::Race(
  lms3dCellWindow undecided, lms3dCellWindow& first, lms3dCellWindow& second)
{
  WideColumns wideFirst;
  WideColumns wideSecond;
  int unchanged = 0;
  for (int step = 1; step < Reach && unchanged < 2; ++step)
  {
    undecided -= first;
    undecided -= second;
    if (!undecided.HasCells())
    {
      return;
    }
    const bool hasEight = step % 2 == 0;
    Prepare(hasEight, first.Left, first.Right, wideFirst);
    Prepare(hasEight, second.Left, second.Right, wideSecond);
    const bool isLeft = GiveCells(0, wideFirst, wideSecond, first.Left, second.Left);
    const bool isRight = GiveCells(1, wideFirst, wideSecond, first.Right, second.Right);
    unchanged = isLeft || isRight ? 0 : unchanged + 1;
  }
}

bool lms3dCellWindow::HasCells() const
{
  return HasBits(this->Left) || HasBits(this->Right);
}

void lms3dCellWindow::Invert()
{
  for (int row = 0; row < Rows; ++row)
  {
    this->Left[row] = ~this->Left[row];
    this->Right[row] = ~this->Right[row];
  }
}

// Shifts that add up to eight cells widen the cells, then what is not among them.
void lms3dCellWindow::Close()
{
  for (int round = 0; round < 2; ++round)
  {
    for (const int shift : { 1, 2, 4, 1 })
    {
      WidenBoth(shift, this->Left, this->Right);
    }
    this->Invert();
  }
}

lms3dCellWindow& lms3dCellWindow::operator|=(const lms3dCellWindow& other)
{
  Unite(other.Left, this->Left);
  Unite(other.Right, this->Right);
  return *this;
}

lms3dCellWindow& lms3dCellWindow::operator&=(const lms3dCellWindow& other)
{
  Intersect(other.Left, this->Left);
  Intersect(other.Right, this->Right);
  return *this;
}

lms3dCellWindow& lms3dCellWindow::operator-=(const lms3dCellWindow& other)
{
  Subtract(other.Left, this->Left);
  Subtract(other.Right, this->Right);
  return *this;
}
