// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dBeamRays.h"

#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double FullCircle = 360.0;
constexpr double Pole = 90.0;

bool IsInScan(const lms3dGridLine& line)
{
  return line.ScanIndex >= 0;
}

// Returns the line of the scan that is nearest to a line. There must be one.
template <typename Distance>
const lms3dGridLine& FindNearest(
  const std::vector<lms3dGridLine>& lines, const lms3dGridLine& to, const Distance& getDistance)
{
  const auto isNearer = [&](const lms3dGridLine& a, const lms3dGridLine& b)
  {
    return IsInScan(a) != IsInScan(b)
      ? IsInScan(a)
      : getDistance(a.Angle - to.Angle) < getDistance(b.Angle - to.Angle);
  };
  return *std::min_element(lines.begin(), lines.end(), isNearer);
}

double GetAroundCircle(double degrees)
{
  return std::abs(std::remainder(degrees, FullCircle));
}

// Turns a vector clockwise about the z axis.
lms3dVector Turn(const lms3dVector& v, double degrees)
{
  double sine, cosine;
  lms3dSinCosDegrees(degrees, sine, cosine);
  return { cosine * v[0] + sine * v[1], cosine * v[1] - sine * v[0], v[2] };
}

// The ray of a row of the halo beside the ray of a row of the scan, in a column at an angle.
lms3dMapRay Tilt(const lms3dMapRay& beside, double elevation, double degrees)
{
  double sine, cosine;
  lms3dSinCosDegrees(elevation, sine, cosine);
  if (std::abs(elevation) == Pole)
  {
    return { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, sine } };
  }
  const lms3dVector level = lms3dNormalize({ beside.Direction[0], beside.Direction[1], 0.0 });
  const bool isUpright = level == lms3dVector{ 0.0, 0.0, 0.0 };
  const lms3dVector ahead = isUpright ? Turn({ 1.0, 0.0, 0.0 }, degrees) : level;
  return { beside.Origin, { cosine * ahead[0], cosine * ahead[1], sine } };
}
} // namespace

lms3dBeamRays::lms3dBeamRays(const lms3dMapGeometry& geometry,
  const std::vector<lms3dGridLine>& rows, const std::vector<lms3dGridLine>& columns)
  : LargestOffset(geometry.GetDistanceFromAxis())
  , LargestTurn(0.0)
{
  this->Rays.reserve(rows.size() * columns.size());
  for (const lms3dGridLine& column : columns)
  {
    const lms3dGridLine& nearest =
      IsInScan(column) ? column : FindNearest(columns, column, GetAroundCircle);
    this->MakeColumn(geometry, nearest.ScanIndex, column.Angle - nearest.Angle, rows);
  }
  const double step = std::abs(geometry.GetGrid().GetBetaStep()) * lms3dRadiansPerDegree;
  for (int turn = 0; turn < geometry.GetGrid().GetNumberOfTurns(); ++turn)
  {
    const double* turned = geometry.GetTurnedSteps(turn);
    for (int beam = 0; turned && beam < geometry.GetGrid().GetNumberOfBeams(); ++beam)
    {
      this->LargestTurn = std::max(this->LargestTurn, std::abs(turned[beam]) * step);
    }
  }
}

void lms3dBeamRays::SetToAxis(std::size_t index)
{
  lms3dMapRay& ray = this->Rays[index];
  ray = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, ray.Direction[2] < 0.0 ? -1.0 : 1.0 } };
}

// A column `degrees` beside a turn.
void lms3dBeamRays::MakeColumn(const lms3dMapGeometry& geometry, int turn, double degrees,
  const std::vector<lms3dGridLine>& rows)
{
  for (const lms3dGridLine& row : rows)
  {
    const lms3dGridLine& nearest = IsInScan(row)
      ? row
      : FindNearest(rows, row, [](double distance) { return std::abs(distance); });
    const lms3dMapRay measured = geometry.GetRay(turn, nearest.ScanIndex);
    const lms3dMapRay ray = IsInScan(row)
      ? measured
      : Tilt(measured, row.Angle, geometry.GetGrid().GetBetaAngles()[turn]);
    this->Rays.push_back(degrees == 0.0
        ? ray
        : lms3dMapRay{ Turn(ray.Origin, degrees), Turn(ray.Direction, degrees) });
  }
}
