// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The ranges and the joins of lms3dBeamSphere, from the grid of the scan.
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace
{
// Flags of beams in the order of rows.
struct Flags
{
  const std::uint8_t* First;
  int Step;
};

// Sets a bit of each row whose beam has a flag. Without branches, so that the compiler makes it
// loops over vectors.
void AddJoins(const Flags& flags, int rows, int flag, int join, std::uint8_t* joins)
{
  const auto add = [&](int row, std::uint8_t ofBeam)
  { joins[row] = static_cast<std::uint8_t>(joins[row] | ((ofBeam & flag) != 0 ? join : 0)); };
  if (flags.Step > 0)
  {
    for (int row = 0; row < rows; ++row)
    {
      add(row, flags.First[row]);
    }
    return;
  }
  for (int row = 0; row < rows; ++row)
  {
    add(row, flags.First[-row]);
  }
}

int CountReturns(const double* ranges, int rows)
{
  int count = 0;
  for (int row = 0; row < rows; ++row)
  {
    count += ranges[row] > 0.0 ? 1 : 0;
  }
  return count;
}
} // namespace

// Splits the rows of the scan where the halo interrupts them.
void lms3dBeamSphere::FindRowRuns()
{
  for (int row = 0; row < static_cast<int>(this->RowLines.size()); ++row)
  {
    const int beam = this->RowLines[row].ScanIndex;
    if (beam < 0)
    {
      continue;
    }
    RowRun* const last = this->RowRuns.empty() ? nullptr : &this->RowRuns.back();
    if (last && last->First + last->Count == row)
    {
      last->Step = beam - this->RowLines[row - 1].ScanIndex;
      ++last->Count;
    }
    else
    {
      this->RowRuns.push_back({ row, 1, beam, 1 });
    }
  }
}

void lms3dBeamSphere::Fill(const lms3dRangeGrid& grid)
{
  this->Ranges.resize(this->GetSize());
  this->PoleHalfSpreads.assign(this->Rows, 0.0);
  this->Filled.assign(grid.HasFilledBeams() ? this->GetSize() : 0, 0);
  std::vector<int> returns(this->Columns);
  tbb::parallel_for(
    0, this->Columns, [&](int column) { returns[column] = this->FillColumn(grid, column); });
  this->Returns = std::accumulate(returns.begin(), returns.end(), 0);
}

// Returns the number of returns in the column, without copies of poles.
int lms3dBeamSphere::FillColumn(const lms3dRangeGrid& grid, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  double* const ranges = this->Ranges.data() + this->GetIndex(column, 0);
  std::fill_n(ranges, this->Rows, 0.0);
  for (const RowRun& run : this->RowRuns)
  {
    const double* const first = grid.GetRanges(std::max(turn, 0)) + run.FirstBeam;
    if (turn >= 0 && run.Step > 0)
    {
      std::copy_n(first, run.Count, ranges + run.First);
    }
    else if (turn >= 0)
    {
      std::reverse_copy(first - run.Count + 1, first + 1, ranges + run.First);
    }
  }
  int copies = 0;
  for (const int row : { 0, this->Rows - 1 })
  {
    if (this->IsPoleRow(row))
    {
      // A pole belongs to the columns of the halo as well.
      ranges[row] = grid.GetRange(0, this->RowLines[row].ScanIndex);
      copies += column > 0 && ranges[row] > 0.0 ? 1 : 0;
    }
  }
  return CountReturns(ranges, this->Rows) - copies - this->MarkFilled(grid, column);
}

// Returns how many entries of a column are filled.
int lms3dBeamSphere::MarkFilled(const lms3dRangeGrid& grid, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  int count = 0;
  for (int row = 0; !this->Filled.empty() && turn >= 0 && row < this->Rows; ++row)
  {
    const int beam = this->RowLines[row].ScanIndex;
    if (beam >= 0 && !this->IsPoleRow(row) && grid.IsFilled(turn, beam))
    {
      this->Filled[this->GetIndex(column, row)] = 1;
      ++count;
    }
  }
  return count;
}

void lms3dBeamSphere::Join(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins)
{
  this->Joins.assign(this->GetSize(), 0);
  tbb::parallel_for(0, this->Columns,
    [&](int column)
    {
      this->JoinUp(joins, column);
      this->JoinRight(grid, joins, column);
    });
}

// The flag of two neighbours is stored at the first of them in the order of the scan.
void lms3dBeamSphere::JoinUp(const lms3dRangeJoins& joins, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  for (const RowRun& run : this->RowRuns)
  {
    if (turn >= 0)
    {
      const int first = run.Step > 0 ? run.FirstBeam : run.FirstBeam - 1;
      AddJoins({ joins.GetRow(turn) + first, run.Step }, run.Count - 1, lms3dRangeJoins::AlongFan,
        JoinedUp, this->Joins.data() + this->GetIndex(column, run.First));
    }
  }
}

void lms3dBeamSphere::JoinRight(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  const int next = this->ColumnLines[column + 1 < this->Columns ? column + 1 : 0].ScanIndex;
  const bool turnsFall = grid.GetGeometry().GetBetaStep() < 0.0;
  const int first = turnsFall ? next : turn;
  const bool areNeighbors =
    turn >= 0 && next >= 0 && (first + 1) % grid.GetNumberOfTurns() == (turnsFall ? turn : next);
  const GridIndex start = this->GetIndex(column, 0);
  for (const RowRun& run : this->RowRuns)
  {
    if (areNeighbors)
    {
      AddJoins({ joins.GetRow(first) + run.FirstBeam, run.Step }, run.Count,
        lms3dRangeJoins::AlongTurn, JoinedRight, this->Joins.data() + start + run.First);
    }
  }
  for (const int row : { 0, this->Rows - 1 })
  {
    if (this->IsPoleRow(row))
    {
      std::uint8_t& join = this->Joins[start + row];
      join = static_cast<std::uint8_t>(
        (join & ~JoinedRight) | (this->HasReturn(start + row) ? JoinedRight : 0));
    }
  }
}
