// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dClosedBeams.h"

#include "Device/lms3dScanGeometry.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <cmath>
#include <cstddef>

namespace
{
constexpr double FullCircle = 360.0;

std::vector<double> GetValues(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}
} // namespace

lms3dClosedBeams::lms3dClosedBeams(vtkFieldData* map, vtkFieldData* scan)
  : Alphas(GetValues(scan, "AlphaAngles"))
  , Betas(GetValues(scan, "BetaAngles"))
{
  const std::vector<double> beams = GetValues(map, "ClosedBeamIds");
  if (beams.empty() || this->Alphas.size() < 2 || this->Betas.size() < 2)
  {
    return;
  }
  this->IsFullCircle = lms3dScanGeometry(this->Alphas, this->Betas).IsClosed();
  this->IsClosed.assign(this->Alphas.size() * this->Betas.size(), false);
  for (double beam : beams)
  {
    if (beam >= 0.0 && beam < static_cast<double>(this->IsClosed.size()))
    {
      this->IsClosed[static_cast<std::size_t>(beam)] = true;
    }
  }
}

bool lms3dClosedBeams::AreBeside(double alpha, double beta) const
{
  if (this->IsEmpty())
  {
    return false;
  }
  const double betaStep = this->Betas[1] - this->Betas[0];
  const double turned = std::copysign(1.0, betaStep) * (beta - this->Betas[0]);
  const double turn = (turned - FullCircle * std::floor(turned / FullCircle)) / std::abs(betaStep);
  const double place = (alpha - this->Alphas[0]) / (this->Alphas[1] - this->Alphas[0]);
  const auto isClosed = [&](double ofTurn, double number)
  {
    const auto turns = static_cast<double>(this->Betas.size());
    const double inTurn = this->IsFullCircle && ofTurn >= turns ? ofTurn - turns : ofTurn;
    const auto beams = static_cast<double>(this->Alphas.size());
    return number >= 0.0 && number < beams && inTurn < turns &&
      this->IsClosed[static_cast<std::size_t>(inTurn * beams + number)];
  };
  const double first = std::floor(turn);
  const double lowest = std::floor(place);
  return isClosed(first, lowest) || isClosed(first, lowest + 1.0) ||
    isClosed(first + 1.0, lowest) || isClosed(first + 1.0, lowest + 1.0);
}
