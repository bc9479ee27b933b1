// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dBeamTable.h"

#include "Device/lms3dFan.h"
#include "Device/lms3dTurnFrame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
constexpr double Pi = 3.14159265358979323846;
// Radians. More than the rounding of an angle.
constexpr double Margin = 1e-9;

double GetElevation(const lms3dVector& v)
{
  return std::atan2(v[2], std::hypot(v[0], v[1]));
}

double GetAzimuth(const lms3dVector& v)
{
  return std::atan2(v[1], v[0]);
}
} // namespace

lms3dBeamTable::lms3dBeamTable(const lms3dScanGeometry& geometry)
  : Geometry(geometry)
  , Beams(geometry.GetNumberOfBeams())
  , Size(static_cast<int>(geometry.CountBeamsOfAllTurns()))
  , IsClosed(geometry.IsClosed())
{
  this->FillBeams();
  this->FillBins();
}

void lms3dBeamTable::FillBeams()
{
  const lms3dFan fan(this->Geometry);
  const lms3dPose pose = { { 0.0, 0.0, 0.0 },
    { { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } } };
  const bool hasStarts = !this->Geometry.GetPlatform().IsCentredAndStepped();
  this->Directions.reserve(this->Size);
  for (int turn = 0; turn < this->Geometry.GetNumberOfTurns(); ++turn)
  {
    const lms3dTurnFrame frame = lms3dMakeTurnFrame(this->Geometry, turn, pose);
    for (int beam = 0; beam < this->Beams; ++beam)
    {
      this->Directions.push_back(lms3dNormalize(frame.ToWorld(fan.Directions[beam])));
      if (hasStarts)
      {
        this->Starts.push_back(frame.ToPoint(fan.Origins[beam]));
        this->LargestStart = std::max(this->LargestStart, lms3dGetLength(this->Starts.back()));
      }
    }
  }
}

int lms3dBeamTable::GetRow(double elevation)
{
  const double share = (elevation + Pi / 2.0) / Pi;
  return std::clamp(static_cast<int>(std::floor(share * Rows)), 0, Rows - 1);
}

int lms3dBeamTable::GetColumn(double azimuth)
{
  const int column = static_cast<int>(std::floor((azimuth + Pi) / (2.0 * Pi) * Columns));
  return (column % Columns + Columns) % Columns;
}

void lms3dBeamTable::FillBins()
{
  this->Bins.resize(this->Size);
  this->BinStarts.assign(this->GetNumberOfBins() + 1, 0);
  for (int beam = 0; beam < this->Size; ++beam)
  {
    const lms3dVector& direction = this->Directions[beam];
    this->Bins[beam] = GetRow(GetElevation(direction)) * Columns + GetColumn(GetAzimuth(direction));
    ++this->BinStarts[this->Bins[beam] + 1];
  }
  std::partial_sum(this->BinStarts.begin(), this->BinStarts.end(), this->BinStarts.begin());
  std::vector<int> next(this->BinStarts.begin(), this->BinStarts.end() - 1);
  this->Sorted.resize(this->Size);
  this->Places.resize(this->Size);
  for (int beam = 0; beam < this->Size; ++beam)
  {
    this->Places[beam] = next[this->Bins[beam]]++;
    this->Sorted[this->Places[beam]] = beam;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int beam : this->Sorted)
    {
      this->NarrowDirections[axis].push_back(static_cast<float>(this->Directions[beam][axis]));
    }
  }
}

void lms3dBeamTable::FindBins(
  const lms3dVector& centre, double radius, std::vector<int>& bins) const
{
  const double distance = lms3dGetLength(centre);
  const double reach = radius + this->LargestStart;
  if (reach >= distance)
  {
    for (int bin = 0; bin < this->GetNumberOfBins(); ++bin)
    {
      bins.push_back(bin);
    }
    return;
  }
  const double angle = std::asin(reach / distance) + Margin;
  const double elevation = GetElevation(centre);
  const int lastRow = GetRow(elevation + angle);
  const bool hasPole = std::abs(elevation) + angle >= Pi / 2.0 - Margin;
  const double half = hasPole ? Pi : std::asin(std::sin(angle) / std::cos(elevation)) + Margin;
  const double step = 2.0 * Pi / Columns;
  const int columns = std::min(Columns, static_cast<int>(std::ceil(2.0 * half / step)) + 1);
  const int firstColumn = GetColumn(GetAzimuth(centre) - half);
  for (int row = GetRow(elevation - angle); row <= lastRow; ++row)
  {
    for (int i = 0; i < columns; ++i)
    {
      bins.push_back(row * Columns + (firstColumn + i) % Columns);
    }
  }
}
