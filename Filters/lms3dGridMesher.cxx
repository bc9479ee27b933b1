// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridMesher.h"

#include "lms3dStripPoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace
{
// Each range of turns fetches the turn after it once more.
constexpr int FewestTurns = 16;

constexpr unsigned Even = 0b0101;
constexpr unsigned Odd = 0b1010;

constexpr int Count(unsigned bits)
{
  return (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1);
}

// Bit i of `sides` tells whether corner i is joined with the next. The diagonal between two corners
// cuts off the triangles of the others. More triangles go before shortness.
constexpr std::uint8_t ChooseCell(unsigned sides, bool isEvenDiagonalShorter)
{
  const unsigned sidesBefore = (sides << 1 | sides >> 3) & 0b1111;
  const unsigned whole = sides & sidesBefore;
  const int even = Count(whole & Even);
  const int odd = Count(whole & Odd);
  const bool takeOdd = odd > even || (odd == even && isEvenDiagonalShorter);
  return static_cast<std::uint8_t>(whole & (takeOdd ? Odd : Even));
}

using CellTable = std::array<std::uint8_t, 32>;

// By the sides, and 16 more where the diagonal from corner 0 to corner 2 is the shorter.
constexpr CellTable MakeCellTable()
{
  CellTable table{};
  for (unsigned i = 0; i < table.size(); ++i)
  {
    table[i] = ChooseCell(i % 16, i >= 16);
  }
  return table;
}

constexpr CellTable Table = MakeCellTable();

double Square(double x)
{
  return x * x;
}

/// A piece of a strip of cells.
class CellTile
{
public:
  CellTile(const lms3dRangeGrid& grid, const double* points, int firstBeam)
    : Points(grid, points, firstBeam)
    , FirstCell(firstBeam)
    , Cells(std::min(this->Points.GetNumberOfBeams(), grid.GetNumberOfBeams() - firstBeam) - 1)
  {
  }

  void Fetch(int turn) { this->Points.Fetch(turn); }

  /// Chooses the triangles of the cells between the two turns fetched last; returns their number.
  int Choose(const lms3dRangeJoins& joins, int turn, std::uint8_t* chosen)
  {
    this->CompareDiagonals();
    const std::uint8_t* here = joins.GetRow(turn) + this->FirstCell;
    const std::uint8_t* next = joins.GetRow(turn + 1) + this->FirstCell;
    chosen += this->FirstCell;
    int triangles = 0;
    for (int i = 0; i < this->Cells; ++i)
    {
      const unsigned sides = (here[i] & lms3dRangeJoins::AlongTurn) >> 1 |
        (next[i] & lms3dRangeJoins::AlongFan) << 1 |
        (here[i + 1] & lms3dRangeJoins::AlongTurn) << 1 |
        (here[i] & lms3dRangeJoins::AlongFan) << 3;
      chosen[i] = Table[sides | (this->Excess[i] >= 0.0 ? 16 : 0)];
      triangles += Count(chosen[i]);
    }
    return triangles;
  }

private:
  // By how much the square of the diagonal from corner 1 to 3 is the greater.
  void CompareDiagonals()
  {
    const lms3dStripPoints::Rows& here = this->Points.Here;
    const lms3dStripPoints::Rows& next = this->Points.Next;
    for (int i = 0; i < this->Cells; ++i)
    {
      const double even = Square(here[0][i] - next[0][i + 1]) +
        Square(here[1][i] - next[1][i + 1]) + Square(here[2][i] - next[2][i + 1]);
      const double odd = Square(next[0][i] - here[0][i + 1]) + Square(next[1][i] - here[1][i + 1]) +
        Square(next[2][i] - here[2][i + 1]);
      this->Excess[i] = odd - even;
    }
  }

  lms3dStripPoints Points;
  const int FirstCell;
  const int Cells;
  lms3dStripPoints::Row Excess;
};

vtkIdType* FillStrip(const std::uint8_t* cells, const std::int32_t* here, const std::int32_t* next,
  int count, vtkIdType* out)
{
  for (int i = 0; i < count; ++i)
  {
    const std::array<std::int32_t, 6> corners = { here[i + 1], here[i], next[i], next[i + 1],
      here[i + 1], here[i] };
    const int first = (cells[i] & Odd) != 0 ? 1 : 0;
    for (int corner = first; corner < 4; corner += 2)
    {
      if (cells[i] >> corner & 1)
      {
        out = std::copy_n(corners.data() + corner, 3, out);
      }
    }
  }
  return out;
}
} // namespace

void lms3dGridMesher::ChooseTriangles(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const double* points)
{
  const int turns = grid.GetNumberOfTurns();
  this->Cells.SetShape(turns, grid.GetNumberOfBeams());
  this->FirstTriangles.assign(turns + 1, 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, turns, FewestTurns),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int beam = 0; beam < grid.GetNumberOfBeams() - 1;
           beam += lms3dStripPoints::MostBeams - 1)
      {
        CellTile tile(grid, points, beam);
        tile.Fetch(range.begin());
        for (int turn = range.begin(); turn < range.end(); ++turn)
        {
          tile.Fetch(turn + 1);
          this->FirstTriangles[turn + 1] += tile.Choose(joins, turn, this->Cells.GetRow(turn));
        }
      }
    });
  this->Cells.FillGhosts(grid.IsClosed());
  std::partial_sum(
    this->FirstTriangles.begin(), this->FirstTriangles.end(), this->FirstTriangles.begin());
}

void lms3dGridMesher::FillTriangles(const lms3dRangeGrid& grid, vtkIdType* vertices) const
{
  tbb::parallel_for(0, grid.GetNumberOfTurns(),
    [&](int turn)
    {
      FillStrip(this->Cells.GetRow(turn), grid.GetVertices(turn), grid.GetVertices(turn + 1),
        grid.GetNumberOfBeams() - 1, vertices + 3 * this->FirstTriangles[turn]);
    });
}
