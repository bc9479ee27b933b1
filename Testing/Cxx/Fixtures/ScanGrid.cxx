// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/ScanGrid.h"

#include "Fixtures/TriangleTree.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{
// Where neither fan nor turn has a step: that of the device's platform, one degree.
constexpr double StepOfSingleBeam = 1.0;

std::vector<double> GetValues(vtkDataArray* array)
{
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

double GetStep(const std::vector<double>& angles)
{
  return angles.size() < 2 ? 0.0 : (angles.back() - angles.front()) / (angles.size() - 1.0);
}

// The largest angle between a row of beams and the straight line between two of its beams that
// many radians apart, seen from the sensor: at an elevation a the line's middle is at
// atan(tan(a) / cos(step / 2)).
double GetSag(double step)
{
  constexpr double Widest = 3.0;
  const double ratio = 1.0 / std::cos(0.5 * std::min(step, Widest));
  return std::atan(0.5 * (ratio - 1.0) / std::sqrt(ratio));
}
} // namespace

ScanGrid::ScanGrid(vtkPolyData* scan)
  : Alphas(GetValues(scan->GetFieldData()->GetArray("AlphaAngles")))
  , Betas(GetValues(scan->GetFieldData()->GetArray("BetaAngles")))
  , Ranges(GetValues(scan->GetPointData()->GetArray("Range")))
{
  const double fan = GetStep(this->Alphas);
  const double turn = GetStep(this->Betas);
  this->Closed = this->Betas.size() > 2 &&
    std::abs(std::abs(turn) * static_cast<double>(this->Betas.size()) - 360.0) < 1e-6;
  const double other = fan != 0.0 || turn != 0.0 ? fan + turn : StepOfSingleBeam;
  this->FanStep = vtkMath::RadiansFromDegrees(fan != 0.0 ? fan : other);
  this->TurnStep = vtkMath::RadiansFromDegrees(turn != 0.0 ? turn : other);

  this->Sag = GetSag(std::abs(this->TurnStep)) / std::abs(this->FanStep);

  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  for (int i = 0; i < 3; ++i)
  {
    this->Sensor[i] = matrix->GetTuple1(4 * i + 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axes[axis][i] = matrix->GetTuple1(4 * i + axis);
    }
  }
  this->ReadReturns(scan);
  for (int number = 0; number < this->GetNumberOfBeams(); ++number)
  {
    if (this->IsPole(number))
    {
      this->JoinPole(number);
    }
  }
}

void ScanGrid::ReadReturns(vtkPolyData* scan)
{
  this->Returns.assign(this->Alphas.size() * this->Betas.size(), NoReturn);
  vtkDataArray* beams = scan->GetPointData()->GetArray("BeamId");
  vtkDataArray* cells = scan->GetPointData()->GetArray("CellId");
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    Vector point;
    scan->GetPoint(i, point.data());
    this->Points.push_back(point - this->Sensor);
    this->BeamIds.push_back(static_cast<int>(beams->GetTuple1(i)));
    this->CellIds.push_back(static_cast<vtkIdType>(cells->GetTuple1(i)));
    this->Returns[this->BeamIds.back()] = i;
  }
}

void ScanGrid::JoinPole(int number)
{
  std::vector<vtkIdType>& returns = this->ReturnsOfPoles[number];
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    const vtkIdType at = this->GetReturn({ turn, number });
    if (at != NoReturn)
    {
      returns.push_back(at);
    }
  }
  if (returns.empty())
  {
    return;
  }
  const auto median = returns.begin() + static_cast<std::ptrdiff_t>(returns.size() / 2);
  std::nth_element(returns.begin(), median, returns.end(),
    [&](vtkIdType a, vtkIdType b) { return this->Ranges[a] < this->Ranges[b]; });
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    this->Returns[static_cast<std::size_t>(turn) * this->Alphas.size() + number] = *median;
  }
}

bool ScanGrid::IsPole(int number) const
{
  return std::abs(this->Alphas[number]) == 90.0;
}

double ScanGrid::GetElevation(int number) const
{
  return vtkMath::RadiansFromDegrees(this->Alphas[number]);
}

bool ScanGrid::Contains(const Beam& beam) const
{
  return beam.Number >= 0 && beam.Number < this->GetNumberOfBeams() &&
    (this->Closed || (beam.Turn >= 0 && beam.Turn < this->GetNumberOfTurns()));
}

vtkIdType ScanGrid::GetReturn(const Beam& beam) const
{
  if (!this->Contains(beam))
  {
    return NoReturn;
  }
  const int turns = this->GetNumberOfTurns();
  const int turn = ((beam.Turn % turns) + turns) % turns;
  return this->Returns[static_cast<std::size_t>(turn) * this->Alphas.size() + beam.Number];
}

std::vector<vtkIdType> ScanGrid::GetReturns(const Beam& beam) const
{
  const auto pole = this->ReturnsOfPoles.find(beam.Number);
  if (pole != this->ReturnsOfPoles.end())
  {
    return pole->second;
  }
  const vtkIdType number = this->GetReturn(beam);
  return number == NoReturn ? std::vector<vtkIdType>() : std::vector<vtkIdType>{ number };
}

ScanGrid::Beam ScanGrid::GetBeam(vtkIdType number) const
{
  const int beams = this->GetNumberOfBeams();
  return { this->BeamIds[number] / beams, this->BeamIds[number] % beams };
}

Vector ScanGrid::GetDirection(const Place& place) const
{
  const double alpha =
    vtkMath::RadiansFromDegrees(this->Alphas.front()) + place.Number * this->FanStep;
  const double beta =
    vtkMath::RadiansFromDegrees(this->Betas.front()) + place.Turn * this->TurnStep;
  return std::cos(alpha) * std::cos(beta) * this->Axes[0] +
    -std::cos(alpha) * std::sin(beta) * this->Axes[1] + std::sin(alpha) * this->Axes[2];
}

ScanGrid::Place ScanGrid::GetPlace(const Vector& direction) const
{
  const double x = Dot(direction, this->Axes[0]);
  const double y = Dot(direction, this->Axes[1]);
  const double z = Dot(direction, this->Axes[2]);
  const double alpha = std::atan2(z, std::hypot(x, y));
  const double beta = std::atan2(-y, x);
  // Among angles that differ by full circles, take the one nearest to the middle of the turns.
  const double circle = 2.0 * vtkMath::Pi() / std::abs(this->TurnStep);
  const double turn = (beta - vtkMath::RadiansFromDegrees(this->Betas.front())) / this->TurnStep;
  const double middle = 0.5 * (this->GetNumberOfTurns() - 1);
  return { turn - circle * std::round((turn - middle) / circle),
    (alpha - vtkMath::RadiansFromDegrees(this->Alphas.front())) / this->FanStep };
}

std::vector<ScanGrid::Beam> ScanGrid::GetBeamsAround(const Place& place, double steps) const
{
  // A place on a beam may come out a little beside it.
  const double reach = steps + 1e-6;
  std::vector<Beam> beams;
  const auto getFirst = [](double low) { return static_cast<int>(std::ceil(low)); };
  const auto getLast = [](double high) { return static_cast<int>(std::floor(high)); };
  for (int turn = getFirst(place.Turn - reach); turn <= getLast(place.Turn + reach); ++turn)
  {
    for (int number = getFirst(place.Number - reach - this->Sag);
         number <= getLast(place.Number + reach + this->Sag); ++number)
    {
      beams.push_back({ turn, number });
    }
  }
  return beams;
}

double ScanGrid::GetCellSize(const Beam& beam) const
{
  const double alpha =
    vtkMath::RadiansFromDegrees(this->Alphas.front()) + beam.Number * this->FanStep;
  const double widest =
    std::cos(std::max(std::abs(alpha) - std::abs(this->FanStep), 0.0)) * this->TurnStep;
  return std::hypot(widest, this->FanStep);
}

std::string ScanGrid::Describe(const Beam& beam) const
{
  std::ostringstream words;
  words.precision(10);
  words << "beam " << beam.Number << " of turn " << beam.Turn;
  const vtkIdType number = this->GetReturn(beam);
  if (number == NoReturn)
  {
    words << ", without a return";
  }
  else
  {
    words << " at " << this->Ranges[number] << " m";
  }
  return words.str();
}
