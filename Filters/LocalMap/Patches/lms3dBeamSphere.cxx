// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include "Geometry/lms3dAngle.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace
{
// The step around a single beam, which has no step of its own, degrees.
constexpr double DefaultStep = 1.0;
// The range at which a beam counts if no neighbour has a return, metres.
constexpr double DefaultRange = 1000.0;
// Radians. Only so that there is no division by 0.
constexpr double MinimumHeight = 1e-9;

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

lms3dBeamSphere::lms3dBeamSphere(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const lms3dMapGeometry* mapGeometry)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  const bool isRegular = !mapGeometry || mapGeometry->IsRegular();
  double alphaStep = std::abs(geometry.GetAlphaStep());
  double betaStep = std::abs(geometry.GetBetaStep());
  alphaStep = alphaStep > 0.0 ? alphaStep : (betaStep > 0.0 ? betaStep : DefaultStep);
  betaStep = betaStep > 0.0 ? betaStep : alphaStep;
  this->MakeRows(
    geometry.GetAlphaAngles(), alphaStep, isRegular || mapGeometry->GetDistanceFromAxis() == 0.0);
  this->MakeColumns(
    geometry.GetBetaAngles(), betaStep, grid.IsClosed(), isRegular ? 0 : mapGeometry->GetSeam());
  CheckSize(static_cast<std::int64_t>(this->RowLines.size()),
    static_cast<std::int64_t>(this->ColumnLines.size()));
  this->Rows = static_cast<int>(this->RowLines.size());
  this->Columns = static_cast<int>(this->ColumnLines.size());
  while ((MaximumSize + 1) * static_cast<std::int64_t>(this->Rows) > std::int64_t(1)
      << this->InverseShift)
  {
    ++this->InverseShift;
  }
  this->InverseOfRows = ((std::uint64_t(1) << this->InverseShift) - 1) / this->Rows + 1;
  this->LastColumn = this->Rows * (this->Columns - 1);
  this->Fill(grid);
  if (!isRegular)
  {
    this->FollowRays(*mapGeometry);
  }
  this->Join(grid, joins);
}

void lms3dBeamSphere::CheckSize(std::int64_t rows, std::int64_t columns)
{
  if (columns > MaximumSize / rows)
  {
    throw std::runtime_error("The scan needs " + std::to_string(rows) + " x " +
      std::to_string(columns) + " directions for a map within MaximumError; at most " +
      std::to_string(MaximumSize) +
      " are possible. Choose lower resolutions or a MaximumError of 0.");
  }
}

void lms3dBeamSphere::MakeRows(const std::vector<double>& angles, double step, bool arePoles)
{
  const std::vector<lms3dGridLine> lines = lms3dMakeRowLines(angles, step, arePoles);
  // The halo surrounds rows that are not poles.
  this->LowestIsPole = lines.front().ScanIndex >= 0;
  this->HighestIsPole = lines.back().ScanIndex >= 0;
  for (const lms3dGridLine& line : lines)
  {
    double sine, cosine;
    lms3dSinCosDegrees(line.Angle, sine, cosine);
    this->Sines.push_back(sine);
    this->Cosines.push_back(cosine);
    this->Tangents.push_back(
      cosine > 0.0 ? sine / cosine : std::copysign(std::numeric_limits<double>::infinity(), sine));
  }
  this->LowestElevation = lines.front().Angle * lms3dRadiansPerDegree;
  this->RowDensity = static_cast<double>(lines.size() - 1) /
    std::max(lines.back().Angle * lms3dRadiansPerDegree - this->LowestElevation, MinimumHeight);
  this->RowLines = lines;
  this->FindRowRuns();
}

int lms3dBeamSphere::GetRowNear(double tangent) const
{
  // The arc tangent within 0.004 radians.
  constexpr double Slope = 0.273;
  const double size = std::abs(tangent);
  const double x = size <= 1.0 ? size : 1.0 / size;
  const double part = x * (lms3dPi / 4.0 + Slope * (1.0 - x));
  const double elevation = std::copysign(size <= 1.0 ? part : lms3dPi / 2.0 - part, tangent);
  const double row = std::max(0.0, (elevation - this->LowestElevation) * this->RowDensity + 0.5);
  return static_cast<int>(std::min<double>(row, this->Rows));
}

void lms3dBeamSphere::MakeColumns(
  const std::vector<double>& angles, double step, bool isClosed, int seam)
{
  const std::vector<lms3dGridLine> lines =
    lms3dAddSeams(lms3dMakeColumnLines(angles, step, isClosed), seam, isClosed);
  for (const lms3dGridLine& line : lines)
  {
    double sine, cosine;
    lms3dSinCosDegrees(line.Angle, sine, cosine);
    this->Horizontals.push_back({ cosine, -sine });
    this->Azimuths.push_back(line.Angle * lms3dRadiansPerDegree);
  }
  this->ColumnLines = lines;
}

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

// Replaces ranges along beams by distances from the origin.
void lms3dBeamSphere::FollowRays(const lms3dMapGeometry& geometry)
{
  this->Rays = std::make_unique<lms3dBeamRays>(geometry, this->RowLines, this->ColumnLines);
  this->InterlacedRows = geometry.GetInterlacedBeams();
  this->RangesOnBeams = this->Ranges;
  this->Directions.resize(this->Ranges.size());
  for (GridIndex index = 0; index < this->GetSize(); ++index)
  {
    const double range = this->Ranges[index];
    const lms3dVector point = this->GetPointOnRay(index, range);
    const double distance = lms3dGetLength(point);
    const bool isBeyond =
      range > 0.0 && (distance == 0.0 || this->IsBeyondAxis(geometry, index, range));
    if (isBeyond)
    {
      this->PointsBeyondAxis.push_back(point);
      this->RangesOnBeams[index] = 0.0;
      this->Rays->SetToAxis(index);
      --this->Returns;
    }
    this->Ranges[index] = range > 0.0 && !isBeyond ? distance : 0.0;
    this->Directions[index] = lms3dNormalize(point);
  }
  this->PointAtNeighbors(geometry);
}

bool lms3dBeamSphere::IsBeyondAxis(
  const lms3dMapGeometry& geometry, GridIndex index, double range) const
{
  const int turn = this->GetTurn(index);
  const int beam = this->GetBeam(index);
  return turn >= 0 && beam >= 0 && !this->IsPoleRow(this->GetRow(index)) &&
    geometry.IsBeyondAxis(turn, beam, range);
}

// Without a return, the direction of a beam depends on how far it goes.
void lms3dBeamSphere::PointAtNeighbors(const lms3dMapGeometry& geometry)
{
  for (GridIndex index = 0; index < this->GetSize(); ++index)
  {
    double range = this->RangesOnBeams[index];
    for (int side = Up; side <= Left && range == 0.0; ++side)
    {
      range =
        this->HasNeighbor(index, side) ? this->RangesOnBeams[this->GetNeighbor(index, side)] : 0.0;
    }
    if (this->Ranges[index] == 0.0)
    {
      range = range > 0.0 ? range : DefaultRange;
      if (this->IsBeyondAxis(geometry, index, range))
      {
        this->Rays->SetToAxis(index);
      }
      this->Directions[index] = this->GetDirectionAt(index, range);
    }
  }
}

void lms3dBeamSphere::SetPole(int row, double nearest, double farthest)
{
  for (int column = 0; column < this->Columns; ++column)
  {
    this->Ranges[this->GetIndex(column, row)] = 0.5 * (nearest + farthest);
    if (this->Rays)
    {
      this->RangesOnBeams[this->GetIndex(column, row)] = 0.5 * (nearest + farthest);
    }
  }
  this->PoleHalfSpreads[row] = 0.5 * (farthest - nearest);
}

void lms3dBeamSphere::Remove(GridIndex index)
{
  this->Filled[index] = 0;
  this->Ranges[index] = 0.0;
  if (this->Rays)
  {
    this->RangesOnBeams[index] = 0.0;
  }
  this->Joins[index] = 0;
  this->Joins[this->GetNeighbor(index, Left)] &= static_cast<std::uint8_t>(~JoinedRight);
  if (this->HasNeighbor(index, Down))
  {
    this->Joins[this->GetNeighbor(index, Down)] &= static_cast<std::uint8_t>(~JoinedUp);
  }
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
