// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCellWindow.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>

namespace
{
using Column = lms3dCellWindow::Column;
constexpr int Rows = lms3dCellWindow::Rows;
constexpr int Half = lms3dCellWindow::Size / 2;

// Adds the cells that are `shift` cells to the left and to the right.
LMS3D_WIDE_LOOPS void AddBeside(int shift, Column& left, Column& right)
{
  for (int row = 0; row < Rows; ++row)
  {
    const std::uint64_t l = left[row];
    const std::uint64_t r = right[row];
    left[row] |= l << shift | l >> shift | r << (lms3dCellWindow::Size - shift);
    right[row] |= r << shift | r >> shift | l >> (lms3dCellWindow::Size - shift);
  }
}

// Adds the cells of `from` that are `shift` rows above and below.
LMS3D_WIDE_LOOPS void AddAbove(int shift, const Column& from, Column& column)
{
  for (int row = shift; row < Rows; ++row)
  {
    column[row] |= from[row - shift];
  }
  for (int row = 0; row < Rows - shift; ++row)
  {
    column[row] |= from[row + shift];
  }
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
} // namespace

void lms3dCellWindow::Add(int u, int v, const lms3dBits& bits)
{
  const int first = std::max(v * Size, -Reach);
  const int end = std::min((v + 1) * Size, Size + Reach);
  for (int row = first; row < end; ++row)
  {
    const std::uint64_t word = bits[row - v * Size];
    const int place = row + Reach;
    this->Left[place] |= u < 0 ? word >> Half : (u > 0 ? 0 : word << Half);
    this->Right[place] |= u > 0 ? word << Half : (u < 0 ? 0 : word >> Half);
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

void lms3dCellWindow::Widen(int neighbours)
{
  if (neighbours == 8)
  {
    this->WidenBy(1);
    return;
  }
  const lms3dCellWindow before = *this;
  AddBeside(1, this->Left, this->Right);
  AddAbove(1, before.Left, this->Left);
  AddAbove(1, before.Right, this->Right);
}

// Adds the cells of three by three that are `shift` cells apart.
void lms3dCellWindow::WidenBy(int shift)
{
  AddBeside(shift, this->Left, this->Right);
  const lms3dCellWindow wide = *this;
  AddAbove(shift, wide.Left, this->Left);
  AddAbove(shift, wide.Right, this->Right);
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
      this->WidenBy(shift);
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
