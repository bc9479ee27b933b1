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
// Degrees.
constexpr double Pole = 90.0;
constexpr double FullCircle = 360.0;
constexpr double MaximumGap = 120.0;
// The step around a single beam, which has no step of its own.
constexpr double DefaultStep = 1.0;
// For the rounding of angles.
constexpr double AngleTolerance = 1e-6;
} // namespace

lms3dBeamSphere::lms3dBeamSphere(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  double alphaStep = std::abs(geometry.GetAlphaStep());
  double betaStep = std::abs(geometry.GetBetaStep());
  alphaStep = alphaStep > 0.0 ? alphaStep : (betaStep > 0.0 ? betaStep : DefaultStep);
  betaStep = betaStep > 0.0 ? betaStep : alphaStep;
  this->MakeRows(geometry.GetAlphaAngles(), std::min(alphaStep, MaximumGap / 2));
  this->MakeColumns(geometry.GetBetaAngles(), std::min(betaStep, MaximumGap / 2), grid.IsClosed());
  CheckSize(static_cast<std::int64_t>(this->RowLines.size()),
    static_cast<std::int64_t>(this->ColumnLines.size()));
  this->Rows = static_cast<int>(this->RowLines.size());
  this->Columns = static_cast<int>(this->ColumnLines.size());
  this->LastColumn = this->Rows * (this->Columns - 1);
  this->Fill(grid);
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

// Lines in growing order.
std::vector<lms3dBeamSphere::GridLine> lms3dBeamSphere::MakeLines(
  const std::vector<double>& angles, const char* name)
{
  std::vector<GridLine> lines;
  lines.reserve(angles.size());
  for (double angle : angles)
  {
    lines.push_back({ angle, static_cast<int>(lines.size()) });
  }
  if (angles.size() > 1 && angles[1] < angles[0])
  {
    std::reverse(lines.begin(), lines.end());
  }
  const auto falls = [](const GridLine& a, const GridLine& b) { return !(a.Angle < b.Angle); };
  const auto wrong = std::adjacent_find(lines.begin(), lines.end(), falls);
  if (wrong != lines.end())
  {
    throw std::runtime_error("The scan's " + std::string(name) + " contains " +
      std::to_string(wrong->Angle) + " next to " + std::to_string((wrong + 1)->Angle) +
      "; strictly increasing or strictly decreasing angles are expected.");
  }
  return lines;
}

// Adds lines of the halo where neighbors are too far apart for a cell: one step from each beam, and more
// in between.
void lms3dBeamSphere::FillGaps(std::vector<GridLine>& lines, double step)
{
  std::vector<GridLine> filled;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    filled.push_back(lines[i]);
    if (i + 1 == lines.size() || lines[i + 1].Angle - lines[i].Angle <= MaximumGap + AngleTolerance)
    {
      continue;
    }
    const double first = lines[i].Angle + (lines[i].ScanIndex >= 0 ? step : 0.0);
    const double last = lines[i + 1].Angle - (lines[i + 1].ScanIndex >= 0 ? step : 0.0);
    const int parts = static_cast<int>(std::ceil((last - first) / MaximumGap));
    for (int part = lines[i].ScanIndex >= 0 ? 0 : 1; part < parts; ++part)
    {
      filled.push_back({ first + part * (last - first) / parts, -1 });
    }
    if (lines[i + 1].ScanIndex >= 0)
    {
      filled.push_back({ last, -1 });
    }
  }
  lines = filled;
}

void lms3dBeamSphere::MakeRows(const std::vector<double>& angles, double step)
{
  std::vector<GridLine> lines = MakeLines(angles, "AlphaAngles");
  if (lines.front().Angle < -Pole || lines.back().Angle > Pole)
  {
    throw std::runtime_error("The scan's AlphaAngles reach from " +
      std::to_string(lines.front().Angle) + " to " + std::to_string(lines.back().Angle) +
      "; elevations from -90 to 90 degrees are expected.");
  }
  this->LowestIsPole = lines.front().Angle == -Pole;
  this->HighestIsPole = lines.back().Angle == Pole;
  if (!this->LowestIsPole)
  {
    lines.insert(lines.begin(), { std::max(-Pole, lines.front().Angle - step), -1 });
  }
  if (!this->HighestIsPole)
  {
    lines.push_back({ std::min(Pole, lines.back().Angle + step), -1 });
  }
  FillGaps(lines, step);
  for (const GridLine& line : lines)
  {
    double sine, cosine;
    lms3dSinCosDegrees(line.Angle, sine, cosine);
    this->Sines.push_back(sine);
    this->Cosines.push_back(cosine);
    this->Tangents.push_back(
      cosine > 0.0 ? sine / cosine : std::copysign(std::numeric_limits<double>::infinity(), sine));
  }
  this->RowLines = lines;
}

void lms3dBeamSphere::MakeColumns(const std::vector<double>& angles, double step, bool isClosed)
{
  std::vector<GridLine> lines = MakeLines(angles, "BetaAngles");
  const double gap = FullCircle - (lines.back().Angle - lines.front().Angle);
  if (!isClosed && gap <= AngleTolerance)
  {
    throw std::runtime_error("The scan's BetaAngles reach from " +
      std::to_string(lines.front().Angle) + " to " + std::to_string(lines.back().Angle) +
      "; a range of less than 360 degrees is expected.");
  }
  if (!isClosed && gap < 3.0 * step)
  {
    lines.push_back({ lines.back().Angle + gap / 2, -1 });
  }
  else if (!isClosed)
  {
    const double first = lines.front().Angle - step + FullCircle;
    lines.push_back({ lines.back().Angle + step, -1 });
    lines.push_back({ first, -1 });
  }
  FillGaps(lines, step);
  for (const GridLine& line : lines)
  {
    double sine, cosine;
    lms3dSinCosDegrees(line.Angle, sine, cosine);
    this->Horizontals.push_back({ cosine, -sine });
    this->Azimuths.push_back(line.Angle * lms3dRadiansPerDegree);
  }
  this->ColumnLines = lines;
}

void lms3dBeamSphere::Fill(const lms3dRangeGrid& grid)
{
  this->Ranges.assign(this->GetSize(), 0.0);
  this->PoleHalfSpreads.assign(this->Rows, 0.0);
  std::vector<int> returns(this->Columns);
  tbb::parallel_for(
    0, this->Columns, [&](int column) { returns[column] = this->FillColumn(grid, column); });
  this->Returns = std::accumulate(returns.begin(), returns.end(), 0);
}

// Returns the number of returns in the column, without copies of poles.
int lms3dBeamSphere::FillColumn(const lms3dRangeGrid& grid, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  double* ranges = this->Ranges.data() + this->GetIndex(column, 0);
  int returns = 0;
  for (int row = 0; row < this->Rows; ++row)
  {
    const int beam = this->RowLines[row].ScanIndex;
    const bool isPole = this->IsPoleRow(row);
    // A pole belongs to the columns of the halo as well.
    if (beam >= 0 && (turn >= 0 || isPole))
    {
      ranges[row] = grid.GetRange(std::max(turn, 0), beam);
      returns += ranges[row] > 0.0 && !(isPole && column > 0);
    }
  }
  return returns;
}

void lms3dBeamSphere::SetPole(int row, double nearest, double farthest)
{
  for (int column = 0; column < this->Columns; ++column)
  {
    this->Ranges[this->GetIndex(column, row)] = 0.5 * (nearest + farthest);
  }
  this->PoleHalfSpreads[row] = 0.5 * (farthest - nearest);
}

void lms3dBeamSphere::Join(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins)
{
  this->Joins.assign(this->GetSize(), 0);
  tbb::parallel_for(0, this->Columns,
    [&](int column)
    {
      this->JoinUp(grid, joins, column);
      this->JoinRight(grid, joins, column);
    });
}

// The flag of two neighbors is stored at the first of them in the order of the scan.
void lms3dBeamSphere::JoinUp(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column)
{
  const int turn = this->ColumnLines[column].ScanIndex;
  if (turn < 0)
  {
    return;
  }
  const bool beamsFall = grid.GetGeometry().GetAlphaStep() < 0.0;
  const std::uint8_t* flags = joins.GetRow(turn);
  std::uint8_t* out = this->Joins.data() + this->GetIndex(column, 0);
  for (int row = 0; row + 1 < this->Rows; ++row)
  {
    const int beam = this->RowLines[row].ScanIndex;
    const int above = this->RowLines[row + 1].ScanIndex;
    if (beam >= 0 && above >= 0 && std::abs(beam - above) == 1 &&
      (flags[beamsFall ? above : beam] & lms3dRangeJoins::AlongFan))
    {
      out[row] |= JoinedUp;
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
  const std::uint8_t* flags = areNeighbors ? joins.GetRow(first) : nullptr;
  const GridIndex start = this->GetIndex(column, 0);
  for (int row = 0; row < this->Rows; ++row)
  {
    const int beam = this->RowLines[row].ScanIndex;
    const bool isJoined = this->IsPoleRow(row)
      ? this->HasReturn(start + row)
      : areNeighbors && beam >= 0 && (flags[beam] & lms3dRangeJoins::AlongTurn);
    this->Joins[start + row] |= isJoined ? JoinedRight : 0;
  }
}
