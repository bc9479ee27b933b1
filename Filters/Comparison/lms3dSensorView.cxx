// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dSensorView.h"

#include "Device/lms3dFan.h"
#include "Device/lms3dScanChecks.h"
#include "Device/lms3dScanFieldData.h"
#include "Geometry/lms3dAngle.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr double FullCircle = 360.0;

// Degrees; allows for rounding at the border of the view.
constexpr double BorderTolerance = 1e-9;

// The relative rounding of distances from the axis.
constexpr double Rounding = 1e-12;

std::vector<double> GetNumbers(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfValues() == 0)
  {
    throw std::runtime_error("The sensor's pose and angles are missing: there is no field data " +
      std::string(name) + ". Connect the scan that the map was made from as third input.");
  }
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    numbers.push_back(
      array->GetComponent(i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents()));
    if (!std::isfinite(numbers.back()))
    {
      throw std::runtime_error("The field data " + std::string(name) + " is not finite.");
    }
  }
  return numbers;
}
} // namespace

lms3dSensorView::lms3dSensorView(vtkFieldData* data, const lms3dRangeLimits& limits)
  : Limits(limits)
  , Platform(lms3dGetPlatform(data))
  , Offset(lms3dToPlatformAxes(this->Platform.Mounting, this->Platform.AxisOffset))
  , IsCentred(this->Platform.AxisOffset == lms3dVector{ 0.0, 0.0, 0.0 })
{
  const std::vector<double> matrix = GetNumbers(data, "SensorToWorld");
  if (matrix.size() != 16)
  {
    throw std::runtime_error("The field data SensorToWorld has " + std::to_string(matrix.size()) +
      " numbers; a matrix of 16 is expected.");
  }
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      this->Axes[column][row] = matrix[4 * row + column];
    }
    this->Position[row] = matrix[4 * row + 3];
  }
  const std::string error = lms3dFindAxesError({ this->Position, this->Axes });
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  this->Axes = lms3dGetPlatformAxes(this->Platform.Mounting, this->Axes);
  const lms3dScanGeometry geometry(
    GetNumbers(data, "AlphaAngles"), GetNumbers(data, "BetaAngles"), this->Platform);
  const std::vector<double>& alpha = geometry.GetAlphaAngles();
  const auto alphas = std::minmax(alpha.front(), alpha.back());
  const auto betas = std::minmax(geometry.GetBetaAngles().front(), geometry.GetBetaAngles().back());
  this->LowestAlpha = alphas.first;
  this->HighestAlpha = alphas.second;
  this->FirstAlpha = alpha.front();
  this->FirstBeta = betas.first;
  this->IsClosed = geometry.IsClosed();
  this->BetaExtent = this->IsClosed ? FullCircle : betas.second - betas.first;
  // The half fan of the first turn on the other side of the axis follows the last turn.
  const double halfCircle = std::abs(geometry.GetBetaStep()) * geometry.GetNumberOfTurns();
  if (this->Platform.IsFanAlongAxis() && lms3dIsFullCircle(2.0 * halfCircle) &&
    std::abs(alphas.first + alphas.second) <= BorderTolerance)
  {
    this->BetaExtent = halfCircle;
  }
  const double turnedByMirrorTurn = this->Platform.TurnRate / lms3dMirrorRate;
  this->TurnedByFan = turnedByMirrorTurn * (lms3dCountMirrorTurns(geometry) - 1);
  this->TurnedByDegree = turnedByMirrorTurn / FullCircle;
}

// On the level of the platform, a beam runs at the distance Offset[1] beside the axis. It passes
// the point either before or behind its nearest place to the axis.
lms3dSensorView::Beam lms3dSensorView::FindBeam(const lms3dVector& point, int way) const
{
  const lms3dVector to = lms3dSubtract(point, this->Position);
  const double x = lms3dDot(this->Axes[0], to);
  const double y = lms3dDot(this->Axes[1], to);
  const double z = lms3dDot(this->Axes[2], to);
  if (this->IsCentred)
  {
    return { std::hypot(x, y), z, -lms3dDegreesPerRadian * std::atan2(y, x), true };
  }
  const double aside = this->Offset[1];
  const double square = x * x + y * y - aside * aside;
  const double ahead = std::sqrt(std::max(0.0, square)) * (way == 0 ? 1.0 : -1.0);
  return { ahead - this->Offset[0], z - this->Offset[2],
    lms3dDegreesPerRadian * std::atan2(x * aside - y * ahead, x * ahead + y * aside),
    square >= -Rounding * aside * aside };
}

double lms3dSensorView::GetRange(const lms3dVector& point, int way) const
{
  if (this->IsCentred)
  {
    const lms3dVector beam = lms3dSubtract(point, this->Position);
    return std::hypot(beam[0], beam[1], beam[2]);
  }
  const Beam beam = this->FindBeam(point, way);
  return std::hypot(beam.Forward, beam.Along);
}

lms3dVector lms3dSensorView::GetStart(const lms3dVector& point, int way) const
{
  const Beam beam = this->FindBeam(point, way);
  if (this->IsCentred || !beam.Exists)
  {
    return this->Position;
  }
  double sine, cosine;
  lms3dSinCosDegrees(beam.Beta, sine, cosine);
  const lms3dVector fan =
    lms3dSubtract(lms3dScale(this->Axes[0], cosine), lms3dScale(this->Axes[1], sine));
  return lms3dSubtract(
    point, lms3dAdd(lms3dScale(fan, beam.Forward), lms3dScale(this->Axes[2], beam.Along)));
}

bool lms3dSensorView::Covers(const lms3dVector& point, int way) const
{
  const double range = this->GetRange(point, way);
  const Beam beam = this->FindBeam(point, way);
  if (!(beam.Exists && range > 0.0 && range >= this->Limits.Minimum &&
        range <= this->Limits.Maximum))
  {
    return false;
  }
  if (this->IsCentred && beam.Forward <= Rounding * range)
  {
    // All turns measure the axis.
    return this->CoversAlpha(this->Platform.IsFanAlongAxis() ? 0.0
        : beam.Along > 0.0                                   ? 90.0
                                                             : -90.0);
  }
  if (!this->Platform.IsFanAlongAxis())
  {
    return this->CoversAngles(
      lms3dDegreesPerRadian * std::atan2(beam.Along, beam.Forward), beam.Beta);
  }
  // The half of the fan on the other side of the axis reaches the same point half a circle later.
  // Beams of the axis itself belong to both halves.
  const double alpha = lms3dDegreesPerRadian * std::atan2(beam.Forward, beam.Along);
  return this->CoversAngles(alpha, beam.Beta) ||
    (this->IsCentred && this->CoversAngles(-alpha, beam.Beta + 0.5 * FullCircle));
}

std::array<std::array<double, 2>, 2> lms3dSensorView::GetAngles(
  const lms3dVector& point, int way) const
{
  const Beam beam = this->FindBeam(point, way);
  const auto getAngles = [this](double alpha, double beta) -> std::array<double, 2> {
    return { alpha, beta - this->TurnedByDegree * std::abs(alpha - this->FirstAlpha) };
  };
  const double elevation = lms3dDegreesPerRadian * std::atan2(beam.Along, beam.Forward);
  if (!this->Platform.IsFanAlongAxis())
  {
    return { getAngles(elevation, beam.Beta), getAngles(elevation, beam.Beta) };
  }
  const double alpha = 0.25 * FullCircle - elevation;
  return { getAngles(alpha, beam.Beta), getAngles(-alpha, beam.Beta + 0.5 * FullCircle) };
}

bool lms3dSensorView::CoversAlpha(double alpha) const
{
  return alpha >= this->LowestAlpha - BorderTolerance &&
    alpha <= this->HighestAlpha + BorderTolerance;
}

bool lms3dSensorView::CoversAngles(double alpha, double beta) const
{
  const double swept = this->TurnedByDegree * std::abs(alpha - this->FirstAlpha);
  const double begun = std::max(0.0, this->TurnedByFan);
  const double extent =
    this->IsClosed ? FullCircle : this->BetaExtent - std::abs(this->TurnedByFan);
  const double turn = beta - this->FirstBeta - swept - begun + BorderTolerance;
  return this->CoversAlpha(alpha) &&
    turn - FullCircle * std::floor(turn / FullCircle) <= extent + 2.0 * BorderTolerance;
}
