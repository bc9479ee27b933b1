// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dScanGeometry.h"

#include "Geometry/lms3dAngle.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace
{
constexpr double FullCircle = 360.0;

// The largest deviation from a full circle that is attributed to rounding of the angles, degrees.
constexpr double AngleTolerance = 1e-6;

// The end of a full circle would repeat its start.
int CountIntervals(const double range[2], int resolution)
{
  return lms3dIsFullCircle(range[1] - range[0]) ? resolution : resolution - 1;
}

// Weights of both ends keep the ends exact and the angles symmetric about the middle.
std::vector<double> EqualSteps(const double range[2], int resolution)
{
  const int intervals = CountIntervals(range, resolution);
  std::vector<double> angles(resolution, range[0]);
  for (int i = 1; i < resolution; ++i)
  {
    angles[i] = (range[0] * (intervals - i) + range[1] * i) / intervals;
  }
  return angles;
}

void SinesAndCosines(
  const std::vector<double>& angles, std::vector<double>& sines, std::vector<double>& cosines)
{
  sines.resize(angles.size());
  cosines.resize(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    lms3dSinCosDegrees(angles[i], sines[i], cosines[i]);
  }
}

double Step(const std::vector<double>& angles)
{
  return angles.size() < 2 ? 0.0 : (angles.back() - angles.front()) / (angles.size() - 1);
}
} // namespace

bool lms3dIsFullCircle(double extent)
{
  return std::abs(extent - FullCircle) <= AngleTolerance;
}

void lms3dSinCosDegrees(double degrees, double& sine, double& cosine)
{
  const double reduced = std::fmod(degrees, FullCircle);
  const int quarter = static_cast<int>(std::lround(reduced / 90.0));
  const double rest = reduced - 90.0 * quarter;

  double s = std::sin(rest * lms3dRadiansPerDegree);
  double c = std::cos(rest * lms3dRadiansPerDegree);
  if (std::abs(rest) == 45.0)
  {
    c = std::sqrt(0.5);
    s = std::copysign(c, rest);
  }

  // The sum of a negative zero and zero is positive.
  switch (((quarter % 4) + 4) % 4)
  {
    case 0:
      sine = s + 0.0;
      cosine = c;
      break;
    case 1:
      sine = c;
      cosine = -s + 0.0;
      break;
    case 2:
      sine = -s + 0.0;
      cosine = -c;
      break;
    default:
      sine = -c;
      cosine = s + 0.0;
      break;
  }
}

lms3dPose lms3dPose::FromOrientation(const double position[3], const double orientation[3])
{
  double sx, cx, sy, cy, sz, cz;
  lms3dSinCosDegrees(orientation[0], sx, cx);
  lms3dSinCosDegrees(orientation[1], sy, cy);
  lms3dSinCosDegrees(orientation[2], sz, cz);

  // The columns of Rz * Rx * Ry.
  lms3dPose pose;
  pose.Position = { position[0], position[1], position[2] };
  pose.Axes[0] = { cz * cy - sz * sx * sy, sz * cy + cz * sx * sy, -cx * sy };
  pose.Axes[1] = { -sz * cx, cz * cx, sx };
  pose.Axes[2] = { cz * sy + sz * sx * cy, sz * sy - cz * sx * cy, cx * cy };
  return pose;
}

lms3dScanGeometry::lms3dScanGeometry(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, const lms3dPlatform& platform)
  : Platform(platform)
  , AlphaAngles(EqualSteps(alphaRange, alphaResolution))
  , BetaAngles(EqualSteps(betaRange, betaResolution))
{
  this->FillTables();
}

lms3dScanGeometry::lms3dScanGeometry(
  std::vector<double> alphaAngles, std::vector<double> betaAngles, const lms3dPlatform& platform)
  : Platform(platform)
  , AlphaAngles(std::move(alphaAngles))
  , BetaAngles(std::move(betaAngles))
{
  this->FillTables();
}

double lms3dScanGeometry::GetStep(const double range[2], int resolution)
{
  return resolution > 1 ? (range[1] - range[0]) / CountIntervals(range, resolution) : 0.0;
}

void lms3dScanGeometry::FillTables()
{
  SinesAndCosines(this->AlphaAngles, this->AlphaSines, this->AlphaCosines);
  if (this->Platform.IsFanAlongAxis())
  {
    std::swap(this->AlphaSines, this->AlphaCosines);
  }
  SinesAndCosines(this->BetaAngles, this->BetaSines, this->BetaCosines);
}

double lms3dScanGeometry::GetAlphaStep() const
{
  return Step(this->AlphaAngles);
}

double lms3dScanGeometry::GetBetaStep() const
{
  return Step(this->BetaAngles);
}

bool lms3dScanGeometry::IsClosed() const
{
  // Fewer than three turns enclose no area.
  return this->GetNumberOfTurns() >= 3 &&
    lms3dIsFullCircle(std::abs(this->GetBetaStep()) * this->GetNumberOfTurns());
}

bool lms3dScanGeometry::IsMirrored() const
{
  return this->GetAlphaStep() * this->GetBetaStep() < 0.0;
}

bool lms3dScanGeometry::IsPole(int beam) const
{
  const lms3dVector offset =
    lms3dToPlatformAxes(this->Platform.Mounting, this->Platform.AxisOffset);
  return std::abs(this->AlphaAngles[beam]) == (this->Platform.IsFanAlongAxis() ? 0.0 : 90.0) &&
    offset[0] == 0.0 && offset[1] == 0.0;
}

lms3dBeamDirections::lms3dBeamDirections(const lms3dScanGeometry& geometry, const lms3dPose& pose)
  : Geometry(geometry)
  , FanAxes(geometry.GetNumberOfTurns())
  , Up(lms3dGetPlatformAxes(geometry.GetPlatform().Mounting, pose.Axes)[2])
{
  const std::array<lms3dVector, 3> axes =
    lms3dGetPlatformAxes(geometry.GetPlatform().Mounting, pose.Axes);
  for (int turn = 0; turn < geometry.GetNumberOfTurns(); ++turn)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->FanAxes[turn][axis] =
        geometry.GetBetaCosine(turn) * axes[0][axis] - geometry.GetBetaSine(turn) * axes[1][axis];
    }
  }
}
