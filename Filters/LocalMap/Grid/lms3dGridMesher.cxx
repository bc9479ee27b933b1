// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dGridMesher.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace
{
constexpr unsigned Even = 0b0101;
constexpr unsigned Odd = 0b1010;

constexpr int CountBits(unsigned bits)
{
  return (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1);
}

// Returns the triangles of a cell. Bit i of `sides` is set if corner i is joined with the next. A
// diagonal gives the triangles of the two corners beside it. The diagonal of more triangles wins,
// then the shorter.
constexpr std::uint8_t SelectTrianglesOfCell(unsigned sides, bool isEvenDiagonalShorter)
{
  const unsigned sidesBefore = (sides << 1 | sides >> 3) & 0b1111;
  const unsigned whole = sides & sidesBefore;
  const int even = CountBits(whole & Even);
  const int odd = CountBits(whole & Odd);
  const bool takeOdd = odd > even || (odd == even && isEvenDiagonalShorter);
  return static_cast<std::uint8_t>(whole & (takeOdd ? Odd : Even));
}

using CellTable = std::array<std::uint8_t, 32>;

// The index is the sides, plus 16 if the diagonal from corner 0 to corner 2 is the shorter.
constexpr CellTable MakeCellTable()
{
  CellTable table{};
  for (unsigned i = 0; i < table.size(); ++i)
  {
    table[i] = SelectTrianglesOfCell(i % 16, i >= 16);
  }
  return table;
}

constexpr CellTable Table = MakeCellTable();

double Square(double x)
{
  return x * x;
}

// Subtracts the squared diagonals of each cell: from corner 1 to 3, minus from corner 0 to 2.
void CompareDiagonals(const lms3dGridPoints& points, int turn, int cells, double* excess)
{
  const double* hereX = points.GetRow(0, turn);
  const double* hereY = points.GetRow(1, turn);
  const double* hereZ = points.GetRow(2, turn);
  const double* nextX = points.GetRow(0, turn + 1);
  const double* nextY = points.GetRow(1, turn + 1);
  const double* nextZ = points.GetRow(2, turn + 1);
  for (int i = 0; i < cells; ++i)
  {
    const double even = Square(hereX[i] - nextX[i + 1]) + Square(hereY[i] - nextY[i + 1]) +
      Square(hereZ[i] - nextZ[i + 1]);
    const double odd = Square(nextX[i] - hereX[i + 1]) + Square(nextY[i] - hereY[i + 1]) +
      Square(nextZ[i] - hereZ[i + 1]);
    excess[i] = odd - even;
  }
}

// Sets bit i of a cell if its corner i is joined with the next.
void FindSides(const lms3dRangeJoins& joins, int turn, int cells, std::uint8_t* sides)
{
  const std::uint8_t* here = joins.GetRow(turn);
  const std::uint8_t* next = joins.GetRow(turn + 1);
  for (int i = 0; i < cells; ++i)
  {
    sides[i] = (here[i] & lms3dRangeJoins::AlongTurn) >> 1 |
      (next[i] & lms3dRangeJoins::AlongFan) << 1 | (here[i + 1] & lms3dRangeJoins::AlongTurn) << 1 |
      (here[i] & lms3dRangeJoins::AlongFan) << 3;
  }
}

// The triangle of a cell at a pole has three sides along the grid; removes all if one is not
// joined.
void ClearIncompletePoleCells(const std::vector<int>& poles, int cells, std::uint8_t* sides)
{
  constexpr std::uint8_t AfterPole = 0b1110;
  constexpr std::uint8_t BeforePole = 0b1011;
  const auto keepIf = [&](int cell, std::uint8_t whole)
  {
    if (cell >= 0 && cell < cells && sides[cell] != whole)
    {
      sides[cell] = 0;
    }
  };
  for (int pole : poles)
  {
    keepIf(pole, AfterPole);
    keepIf(pole - 1, BeforePole);
  }
}

void SelectTrianglesOfTurn(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
  const lms3dGridPoints& points, int turn, std::uint8_t* selected)
{
  const int cells = grid.GetNumberOfBeams() - 1;
  std::vector<double> excess(cells);
  CompareDiagonals(points, turn, cells, excess.data());
  FindSides(joins, turn, cells, selected);
  ClearIncompletePoleCells(grid.GetPoles(), cells, selected);
  for (int i = 0; i < cells; ++i)
  {
    selected[i] = Table[selected[i] | (excess[i] >= 0.0 ? 16 : 0)];
  }
}

int CountTriangles(const std::uint8_t* selected, int cells)
{
  int triangles = 0;
  for (int i = 0; i < cells; ++i)
  {
    triangles += CountBits(selected[i]);
  }
  return triangles;
}

std::int32_t* WriteTriangle(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t* out)
{
  out[0] = a;
  out[1] = b;
  out[2] = c;
  return out + 3;
}

void FillTrianglesOfTurn(const std::uint8_t* cells, const std::int32_t* here,
  const std::int32_t* next, int count, std::int32_t* out)
{
  for (int i = 0; i < count; ++i)
  {
    const std::int32_t corners[] = { here[i], next[i], next[i + 1], here[i + 1] };
    if (cells[i] & 1)
    {
      out = WriteTriangle(corners[3], corners[0], corners[1], out);
    }
    if (cells[i] & 2)
    {
      out = WriteTriangle(corners[0], corners[1], corners[2], out);
    }
    if (cells[i] & 4)
    {
      out = WriteTriangle(corners[1], corners[2], corners[3], out);
    }
    if (cells[i] & 8)
    {
      out = WriteTriangle(corners[2], corners[3], corners[0], out);
    }
  }
}
} // namespace

void lms3dGridMesher::SelectTriangles(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const lms3dGridPoints& points)
{
  const int turns = grid.GetNumberOfTurns();
  const int cells = grid.GetNumberOfBeams() - 1;
  this->Cells.SetShape(turns, grid.GetNumberOfBeams());
  this->FirstTriangles.assign(turns + 1, 0);
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      std::uint8_t* selected = this->Cells.GetRow(turn);
      if (grid.HasReturns(turn))
      {
        SelectTrianglesOfTurn(grid, joins, points, turn, selected);
        this->FirstTriangles[turn + 1] = CountTriangles(selected, cells);
      }
      else
      {
        std::fill_n(selected, cells, 0);
      }
    });
  this->Cells.FillHalo(grid.IsClosed());
  std::partial_sum(
    this->FirstTriangles.begin(), this->FirstTriangles.end(), this->FirstTriangles.begin());
}

void lms3dGridMesher::FillTriangles(const lms3dRangeGrid& grid, std::int32_t* vertices) const
{
  tbb::parallel_for(0, grid.GetNumberOfTurns(),
    [&](int turn)
    {
      if (this->FirstTriangles[turn] < this->FirstTriangles[turn + 1])
      {
        FillTrianglesOfTurn(this->Cells.GetRow(turn), grid.GetVertices(turn),
          grid.GetVertices(turn + 1), grid.GetNumberOfBeams() - 1,
          vertices + 3 * this->FirstTriangles[turn]);
      }
    });
}
