// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dSensorView.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr double DegreesPerRadian = 57.29577951308232;
constexpr double FullCircle = 360.0;

// Degrees; what the arithmetic of angles may lose at the rim of the view.
constexpr double RimTolerance = 1e-9;

std::vector<double> TakeNumbers(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfValues() == 0)
  {
    throw std::runtime_error("Where the sensor was and what it covered is not known: there is no "
                             "field data " +
      std::string(name) + ". Connect the scan that the map was made of as third input.");
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
{
  const std::vector<double> matrix = TakeNumbers(data, "SensorToWorld");
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
  const lms3dScanGeometry geometry(
    TakeNumbers(data, "AlphaAngles"), TakeNumbers(data, "BetaAngles"));
  const auto alphas =
    std::minmax(geometry.GetAlphaAngles().front(), geometry.GetAlphaAngles().back());
  const auto betas = std::minmax(geometry.GetBetaAngles().front(), geometry.GetBetaAngles().back());
  this->LowestAlpha = alphas.first;
  this->HighestAlpha = alphas.second;
  this->FirstBeta = betas.first;
  this->BetaExtent = geometry.IsClosed() ? FullCircle : betas.second - betas.first;
}

double lms3dSensorView::GetRange(const std::array<double, 3>& point) const
{
  return std::hypot(
    point[0] - this->Position[0], point[1] - this->Position[1], point[2] - this->Position[2]);
}

bool lms3dSensorView::Covers(const std::array<double, 3>& point) const
{
  const double range = this->GetRange(point);
  if (!(range > 0.0 && range >= this->Limits.Minimum && range <= this->Limits.Maximum))
  {
    return false;
  }
  std::array<double, 3> seen{};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      seen[axis] += this->Axes[axis][i] * (point[i] - this->Position[i]);
    }
  }
  const double alpha = DegreesPerRadian * std::atan2(seen[2], std::hypot(seen[0], seen[1]));
  const double beta = -DegreesPerRadian * std::atan2(seen[1], seen[0]);
  const double turn = beta - this->FirstBeta + RimTolerance;
  return alpha >= this->LowestAlpha - RimTolerance && alpha <= this->HighestAlpha + RimTolerance &&
    turn - FullCircle * std::floor(turn / FullCircle) <= this->BetaExtent + 2.0 * RimTolerance;
}
