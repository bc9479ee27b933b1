// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dSensorView.h"

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
  const lms3dScanGeometry geometry(GetNumbers(data, "AlphaAngles"), GetNumbers(data, "BetaAngles"));
  const auto alphas =
    std::minmax(geometry.GetAlphaAngles().front(), geometry.GetAlphaAngles().back());
  const auto betas = std::minmax(geometry.GetBetaAngles().front(), geometry.GetBetaAngles().back());
  this->LowestAlpha = alphas.first;
  this->HighestAlpha = alphas.second;
  this->FirstBeta = betas.first;
  this->BetaExtent = geometry.IsClosed() ? FullCircle : betas.second - betas.first;
}

double lms3dSensorView::GetRange(const lms3dVector& point) const
{
  const lms3dVector beam = lms3dSubtract(point, this->Position);
  return std::hypot(beam[0], beam[1], beam[2]);
}

bool lms3dSensorView::Covers(const lms3dVector& point) const
{
  const double range = this->GetRange(point);
  if (!(range > 0.0 && range >= this->Limits.Minimum && range <= this->Limits.Maximum))
  {
    return false;
  }
  const lms3dVector beam = lms3dSubtract(point, this->Position);
  const double x = lms3dDot(this->Axes[0], beam);
  const double y = lms3dDot(this->Axes[1], beam);
  const double z = lms3dDot(this->Axes[2], beam);
  const double alpha = lms3dDegreesPerRadian * std::atan2(z, std::hypot(x, y));
  const double beta = -lms3dDegreesPerRadian * std::atan2(y, x);
  const double turn = beta - this->FirstBeta + BorderTolerance;
  return alpha >= this->LowestAlpha - BorderTolerance &&
    alpha <= this->HighestAlpha + BorderTolerance &&
    turn - FullCircle * std::floor(turn / FullCircle) <= this->BetaExtent + 2.0 * BorderTolerance;
}
