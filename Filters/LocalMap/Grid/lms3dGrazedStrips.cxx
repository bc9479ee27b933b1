// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dGrazedStrips.h"

#include "Geometry/lms3dAngle.h"
#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dJoinResolver.h"

#include <cmath>

namespace
{
constexpr int MinimumTurns = 5;
// Radians.
constexpr double LargestAngle = 0.036;
// Shares of the depth step.
constexpr double Flatness = 0.02;
constexpr double Roughness = 0.01;
constexpr double FlatnessBeyond = 0.2;

double Square(double x)
{
  return x * x;
}
} // namespace

lms3dGrazedStrips::lms3dGrazedStrips(
  const lms3dRangeGrid& grid, const Flags& joins, double depthStep, double noise)
  : Grid(grid)
  , Joins(joins)
  , Tolerance(Flatness * depthStep + lms3dDepthStep::Deviations * noise)
  , ToleranceBeyond(FlatnessBeyond * depthStep + lms3dDepthStep::Deviations * noise)
  , Deviation(Roughness * depthStep + noise)
{
  double sine, cosine;
  lms3dSinCosDegrees(grid.GetGeometry().GetAlphaStep(), sine, cosine);
  this->TwoCosines = 2.0 * cosine;
  this->IsFine = std::abs(sine) < LargestAngle;
  for (int i = 0; i <= 2 * MaximumReach; ++i)
  {
    lms3dSinCosDegrees((i - MaximumReach) * grid.GetGeometry().GetBetaStep(),
      this->TurnedBy[i].Sine, this->TurnedBy[i].Cosine);
  }
}

bool lms3dGrazedStrips::AreOneSurface(int turn, int beam) const
{
  if (!this->IsFine)
  {
    return false;
  }
  const Window whole = { this->CountJoined(turn, beam, -1), this->CountJoined(turn, beam, 1) };
  const auto isLong = [](const Window& window)
  { return window.Before + window.Behind + 1 >= MinimumTurns; };
  // At a corner of the surface, one side of the pair shows it alone.
  const Window before = { whole.Before, 0 };
  const Window behind = { 0, whole.Behind };
  return (isLong(whole) && this->IsOnePlane(turn, beam, whole)) ||
    (isLong(before) && this->IsOnePlane(turn, beam, before)) ||
    (isLong(behind) && this->IsOnePlane(turn, beam, behind));
}

// The number of turns in a direction over which both strips are joined.
int lms3dGrazedStrips::CountJoined(int turn, int beam, int direction) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  int count = 0;
  for (; count < MaximumReach && 2 * count + 2 < turns; ++count)
  {
    const int from = turn + direction * count - (direction < 0 ? 1 : 0);
    const std::uint8_t* const joins = this->Joins.GetRow((from + turns) % turns) + beam;
    if ((joins[0] & joins[1] & lms3dJoinedAlongTurn) == 0)
    {
      break;
    }
  }
  return count;
}

bool lms3dGrazedStrips::IsOnePlane(int turn, int beam, const Window& window) const
{
  const Plane plane = this->FitPlane(turn, beam, window);
  if (!(this->IsOnPlane(turn, beam - 1, plane) || this->IsOnPlane(turn, beam + 2, plane)) ||
    this->LeavesPlane(turn, beam, -1, plane) || this->LeavesPlane(turn, beam + 1, 1, plane))
  {
    return false;
  }
  double gain = 0.0;
  for (int next : { beam, beam + 1 })
  {
    const Plane upright = this->FitUpright(turn, next, window);
    for (int offset = -window.Before; offset <= window.Behind; ++offset)
    {
      const double residual = this->GetResidual(turn, next, offset, plane);
      if (!(std::abs(residual) <= this->Tolerance))
      {
        return false;
      }
      gain += Square(this->GetResidual(turn, next, offset, upright)) - Square(residual);
    }
  }
  return gain > Square(lms3dDepthStep::Deviations * this->Deviation);
}

// Whether a third strip confirms the plane.
bool lms3dGrazedStrips::IsOnPlane(int turn, int beam, const Plane& plane) const
{
  return beam >= 0 && beam < this->Grid.GetNumberOfBeams() && this->GetRange(turn, beam) > 0.0 &&
    std::abs(this->GetResidual(turn, beam, 0, plane)) <= this->Tolerance;
}

// Whether a return and the two beyond it in the fan lie on another plane.
bool lms3dGrazedStrips::LeavesPlane(int turn, int beam, int outwards, const Plane& plane) const
{
  const int last = beam + 2 * outwards;
  if (last < 0 || last >= this->Grid.GetNumberOfBeams())
  {
    return false;
  }
  const double at = this->GetRange(turn, beam);
  const double beyond = this->GetRange(turn, beam + outwards);
  const double end = this->GetRange(turn, last);
  if (!(beyond > 0.0 && end > 0.0))
  {
    return false;
  }
  const double bend = 1.0 / at + 1.0 / end - this->TwoCosines / beyond;
  const bool isStraight = std::abs(bend) * beyond * beyond <= this->ToleranceBeyond;
  return isStraight &&
    std::abs(this->GetResidual(turn, beam + outwards, 0, plane)) > this->ToleranceBeyond;
}

double lms3dGrazedStrips::GetRange(int turn, int beam) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  return this->Grid.GetRange((turn + turns) % turns, beam);
}

// By least squares.
lms3dGrazedStrips::Plane lms3dGrazedStrips::FitPlane(int turn, int beam, const Window& window) const
{
  const lms3dScanGeometry& geometry = this->Grid.GetGeometry();
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  double ofX = 0.0, ofY = 0.0, ofZ = 0.0;
  for (int next : { beam, beam + 1 })
  {
    const double z = geometry.GetAlphaSine(next);
    for (int offset = -window.Before; offset <= window.Behind; ++offset)
    {
      const double x = geometry.GetAlphaCosine(next) * this->GetTurned(offset).Cosine;
      const double y = geometry.GetAlphaCosine(next) * this->GetTurned(offset).Sine;
      const double inverse = 1.0 / this->GetRange(turn + offset, next);
      xx += x * x;
      xy += x * y;
      xz += x * z;
      yy += y * y;
      yz += y * z;
      zz += z * z;
      ofX += x * inverse;
      ofY += y * inverse;
      ofZ += z * inverse;
    }
  }
  const double minorX = yy * zz - yz * yz;
  const double minorY = xz * yz - xy * zz;
  const double minorZ = xy * yz - xz * yy;
  const double determinant = xx * minorX + xy * minorY + xz * minorZ;
  return { (minorX * ofX + minorY * ofY + minorZ * ofZ) / determinant,
    (minorY * ofX + (xx * zz - xz * xz) * ofY + (xy * xz - xx * yz) * ofZ) / determinant,
    (minorZ * ofX + (xy * xz - xx * yz) * ofY + (xx * yy - xy * xy) * ofZ) / determinant };
}

// The upright plane that fits one strip best.
lms3dGrazedStrips::Plane lms3dGrazedStrips::FitUpright(
  int turn, int beam, const Window& window) const
{
  double xx = 0.0, xy = 0.0, yy = 0.0;
  double ofX = 0.0, ofY = 0.0;
  for (int offset = -window.Before; offset <= window.Behind; ++offset)
  {
    const auto& [x, y] = this->GetTurned(offset);
    const double inverse = 1.0 / this->GetRange(turn + offset, beam);
    xx += x * x;
    xy += x * y;
    yy += y * y;
    ofX += x * inverse;
    ofY += y * inverse;
  }
  const double determinant = (xx * yy - xy * xy) * this->Grid.GetGeometry().GetAlphaCosine(beam);
  return { (yy * ofX - xy * ofY) / determinant, (xx * ofY - xy * ofX) / determinant, 0.0 };
}

// How far a return is from a plane along its beam, metres, for small distances; with a sign.
double lms3dGrazedStrips::GetResidual(int turn, int beam, int offset, const Plane& plane) const
{
  const lms3dScanGeometry& geometry = this->Grid.GetGeometry();
  const double range = this->GetRange(turn + offset, beam);
  const auto& [cosine, sine] = this->GetTurned(offset);
  const double inverse = geometry.GetAlphaCosine(beam) * (plane.X * cosine + plane.Y * sine) +
    geometry.GetAlphaSine(beam) * plane.Up;
  return (1.0 - inverse * range) * range;
}
