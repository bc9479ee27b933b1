// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
