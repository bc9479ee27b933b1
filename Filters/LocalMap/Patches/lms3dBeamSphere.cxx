// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace
{
constexpr double Pole = 90.0;
constexpr double FullCircle = 360.0;
constexpr double MaximumGap = 120.0;
// Degrees between neighbours of a single beam, which has no step of its own.
constexpr double StepOfNone = 1.0;
constexpr double RadiansPerDegree = 3.14159265358979323846 / 180.0;
// Of the rounding of angles.
constexpr double AngleTolerance = 1e-6;
} // namespace

lms3dBeamSphere::lms3dBeamSphere(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  double alphaStep = std::abs(geometry.GetAlphaStep());
  double betaStep = std::abs(geometry.GetBetaStep());
  alphaStep = alphaStep > 0.0 ? alphaStep : (betaStep > 0.0 ? betaStep : StepOfNone);
  betaStep = betaStep > 0.0 ? betaStep : alphaStep;
  this->MakeRows(geometry.GetAlphaAngles(), std::min(alphaStep, MaximumGap / 2));
  this->MakeColumns(geometry.GetBetaAngles(), std::min(betaStep, MaximumGap / 2), grid.IsClosed());
  this->Rows = static_cast<int>(this->RowTicks.size());
  this->Columns = static_cast<int>(this->ColumnTicks.size());
  this->LastColumn = this->Rows * (this->Columns - 1);
  this->Fill(grid);
  this->Join(grid, joins);
}

// In growing order, whichever way the device turns.
std::vector<lms3dBeamSphere::Tick> lms3dBeamSphere::MakeTicks(
  const std::vector<double>& angles, const char* name)
{
  std::vector<Tick> ticks;
  ticks.reserve(angles.size());
  for (double angle : angles)
  {
    ticks.push_back({ angle, static_cast<int>(ticks.size()) });
  }
  if (angles.size() > 1 && angles[1] < angles[0])
  {
    std::reverse(ticks.begin(), ticks.end());
  }
  const auto falls = [](const Tick& a, const Tick& b) { return !(a.Angle < b.Angle); };
  const auto wrong = std::adjacent_find(ticks.begin(), ticks.end(), falls);
  if (wrong != ticks.end())
  {
    throw std::runtime_error("The scan's " + std::string(name) + " holds " +
      std::to_string(wrong->Angle) + " beside " + std::to_string((wrong + 1)->Angle) +
      ". Give angles that grow, or fall, from each to the next.");
  }
  return ticks;
}

// Ghosts close by and in between where neighbours are too far apart for a cell of the grid.
void lms3dBeamSphere::FillGaps(std::vector<Tick>& ticks, double step)
{
  std::vector<Tick> filled;
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    filled.push_back(ticks[i]);
    if (i + 1 == ticks.size() || ticks[i + 1].Angle - ticks[i].Angle <= MaximumGap + AngleTolerance)
    {
      continue;
    }
    const double first = ticks[i].Angle + (ticks[i].Source >= 0 ? step : 0.0);
    const double last = ticks[i + 1].Angle - (ticks[i + 1].Source >= 0 ? step : 0.0);
    const int parts = static_cast<int>(std::ceil((last - first) / MaximumGap));
    for (int part = ticks[i].Source >= 0 ? 0 : 1; part < parts; ++part)
    {
      filled.push_back({ first + part * (last - first) / parts, -1 });
    }
    if (ticks[i + 1].Source >= 0)
    {
      filled.push_back({ last, -1 });
    }
  }
  ticks = filled;
}

void lms3dBeamSphere::MakeRows(const std::vector<double>& angles, double step)
{
  std::vector<Tick> ticks = MakeTicks(angles, "AlphaAngles");
  if (ticks.front().Angle < -Pole || ticks.back().Angle > Pole)
  {
    throw std::runtime_error("The scan's AlphaAngles reach from " +
      std::to_string(ticks.front().Angle) + " to " + std::to_string(ticks.back().Angle) +
      "; elevations from -90 to 90 degrees are expected.");
  }
  this->LowestIsPole = ticks.front().Angle == -Pole;
  this->HighestIsPole = ticks.back().Angle == Pole;
  if (!this->LowestIsPole)
  {
    ticks.insert(ticks.begin(), { std::max(-Pole, ticks.front().Angle - step), -1 });
  }
  if (!this->HighestIsPole)
  {
    ticks.push_back({ std::min(Pole, ticks.back().Angle + step), -1 });
  }
  FillGaps(ticks, step);
  for (const Tick& tick : ticks)
  {
    double sine, cosine;
    lms3dSinCosDegrees(tick.Angle, sine, cosine);
    this->Sines.push_back(sine);
    this->Cosines.push_back(cosine);
    this->Tangents.push_back(
      cosine > 0.0 ? sine / cosine : std::copysign(std::numeric_limits<double>::infinity(), sine));
  }
  this->RowTicks = ticks;
}

void lms3dBeamSphere::MakeColumns(const std::vector<double>& angles, double step, bool isClosed)
{
  std::vector<Tick> ticks = MakeTicks(angles, "BetaAngles");
  const double gap = FullCircle - (ticks.back().Angle - ticks.front().Angle);
  if (!isClosed && gap <= AngleTolerance)
  {
    throw std::runtime_error("The scan's BetaAngles reach from " +
      std::to_string(ticks.front().Angle) + " to " + std::to_string(ticks.back().Angle) +
      "; less than a full turn is expected.");
  }
  if (!isClosed && gap < 3.0 * step)
  {
    ticks.push_back({ ticks.back().Angle + gap / 2, -1 });
  }
  else if (!isClosed)
  {
    const double first = ticks.front().Angle - step + FullCircle;
    ticks.push_back({ ticks.back().Angle + step, -1 });
    ticks.push_back({ first, -1 });
  }
  FillGaps(ticks, step);
  for (const Tick& tick : ticks)
  {
    double sine, cosine;
    lms3dSinCosDegrees(tick.Angle, sine, cosine);
    this->Levels.push_back({ cosine, -sine });
    this->Azimuths.push_back(tick.Angle * RadiansPerDegree);
  }
  this->ColumnTicks = ticks;
}

void lms3dBeamSphere::Fill(const lms3dRangeGrid& grid)
{
  this->Ranges.assign(this->GetSize(), 0.0);
  this->Spreads.assign(this->Rows, 0.0);
  std::vector<int> returns(this->Columns);
  tbb::parallel_for(
    0, this->Columns, [&](int column) { returns[column] = this->FillColumn(grid, column); });
  this->Returns = std::accumulate(returns.begin(), returns.end(), 0);
}

// Returns how many returns it has, repetitions of poles apart.
int lms3dBeamSphere::FillColumn(const lms3dRangeGrid& grid, int column)
{
  const int turn = this->ColumnTicks[column].Source;
  double* ranges = this->Ranges.data() + this->GetIndex(column, 0);
  int returns = 0;
  for (int row = 0; row < this->Rows; ++row)
  {
    const int beam = this->RowTicks[row].Source;
    const bool isPole = this->IsPoleRow(row);
    // A pole is met in the turns of the ghosts as well.
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
  this->Spreads[row] = 0.5 * (farthest - nearest);
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

// The flags of two neighbours are those of the one that comes first in the scan.
void lms3dBeamSphere::JoinUp(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column)
{
  const int turn = this->ColumnTicks[column].Source;
  if (turn < 0)
  {
    return;
  }
  const bool beamsFall = grid.GetGeometry().GetAlphaStep() < 0.0;
  const std::uint8_t* flags = joins.GetRow(turn);
  std::uint8_t* out = this->Joins.data() + this->GetIndex(column, 0);
  for (int row = 0; row + 1 < this->Rows; ++row)
  {
    const int beam = this->RowTicks[row].Source;
    const int above = this->RowTicks[row + 1].Source;
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
  const int turn = this->ColumnTicks[column].Source;
  const int next = this->ColumnTicks[column + 1 < this->Columns ? column + 1 : 0].Source;
  const bool turnsFall = grid.GetGeometry().GetBetaStep() < 0.0;
  const int first = turnsFall ? next : turn;
  const bool areNeighbors =
    turn >= 0 && next >= 0 && (first + 1) % grid.GetNumberOfTurns() == (turnsFall ? turn : next);
  const std::uint8_t* flags = areNeighbors ? joins.GetRow(first) : nullptr;
  const GridIndex start = this->GetIndex(column, 0);
  for (int row = 0; row < this->Rows; ++row)
  {
    const int beam = this->RowTicks[row].Source;
    const bool isJoined = this->IsPoleRow(row)
      ? this->HasReturn(start + row)
      : areNeighbors && beam >= 0 && (flags[beam] & lms3dRangeJoins::AlongTurn);
    this->Joins[start + row] |= isJoined ? JoinedRight : 0;
  }
}
