// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridMesher.h"

#include "lms3dStripPoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <numeric>

namespace
{
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

int ChooseStrip(const lms3dRangeJoins& joins, int turn, const lms3dStripPoints& points, int cells,
  std::uint8_t* out)
{
  const std::uint8_t* here = joins.GetRow(turn);
  const std::uint8_t* next = joins.GetRow(turn + 1);
  points.FindShorterDiagonals(cells, out);
  int triangles = 0;
  for (int i = 0; i < cells; ++i)
  {
    const unsigned sides = (here[i] & lms3dRangeJoins::AlongTurn) >> 1 |
      (next[i] & lms3dRangeJoins::AlongFan) << 1 | (here[i + 1] & lms3dRangeJoins::AlongTurn) << 1 |
      (here[i] & lms3dRangeJoins::AlongFan) << 3;
    out[i] = Table[sides | out[i] << 4];
    triangles += Count(out[i]);
  }
  return triangles;
}

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
  const int cells = grid.GetNumberOfBeams() - 1;
  this->Cells.SetShape(turns, grid.GetNumberOfBeams());
  this->FirstTriangles.assign(turns + 1, 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.GetNumberOfStrips()),
    [&](const tbb::blocked_range<int>& strips)
    {
      lms3dStripPoints stripPoints(grid, points, strips.begin());
      for (int turn = strips.begin(); turn < strips.end(); ++turn)
      {
        stripPoints.MoveTo(turn);
        this->FirstTriangles[turn + 1] =
          ChooseStrip(joins, turn, stripPoints, cells, this->Cells.GetRow(turn));
      }
    });
  this->Cells.FillGhosts(grid.IsClosed());
  std::partial_sum(
    this->FirstTriangles.begin(), this->FirstTriangles.end(), this->FirstTriangles.begin());
}

void lms3dGridMesher::FillTriangles(const lms3dRangeGrid& grid, vtkIdType* vertices) const
{
  tbb::parallel_for(0, grid.GetNumberOfStrips(),
    [&](int turn)
    {
      FillStrip(this->Cells.GetRow(turn), grid.GetVertices(turn), grid.GetVertices(turn + 1),
        grid.GetNumberOfBeams() - 1, vertices + 3 * this->FirstTriangles[turn]);
    });
}
