// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/DepthSteps.h"

#include "Fixtures/TriangleTree.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
// How far from a plane returns on it may lie, metres.
constexpr double Flatness = 0.0005;

// The neighbour of a beam opposite to the next one.
ScanGrid::Beam GetBefore(const ScanGrid::Beam& beam, const ScanGrid::Beam& next)
{
  return { 2 * beam.Turn - next.Turn, 2 * beam.Number - next.Number };
}

double Invert(double inverse)
{
  return inverse > 0.0 ? 1.0 / inverse : std::numeric_limits<double>::infinity();
}
} // namespace

double DepthSteps::GetRange(const Beam& beam) const
{
  const vtkIdType number = this->Grid.GetReturn(beam);
  return number == ScanGrid::NoReturn ? 0.0 : this->Grid.GetRange(number);
}

bool DepthSteps::HaveReturned(const Beam& a, const Beam& b) const
{
  return this->GetRange(a) > 0.0 && this->GetRange(b) > 0.0;
}

double DepthSteps::GetStep(const Beam& a, const Beam& b) const
{
  return std::abs(a.Turn == b.Turn ? this->Grid.GetFanStep() : this->Grid.GetTurnStep());
}

double DepthSteps::GetTolerance(const Beam& a, const Beam& b) const
{
  return this->DepthStep +
    std::max(0.02, this->GetStep(a, b)) * std::min(this->GetRange(a), this->GetRange(b));
}

// The range of b if the surface continues as from the beam before a to a: infinite if the surface
// does not reach b, the range of a if there is no return before.
double DepthSteps::Predict(const Beam& a, const Beam& b) const
{
  const Beam last = { 2 * a.Turn - b.Turn, 2 * a.Number - b.Number };
  if (!this->Grid.Contains(a))
  {
    return this->PredictAlong(a, b);
  }
  const Beam aside = this->GetTowardsHorizon(a);
  const bool hasAside = a.Turn != b.Turn && this->GetRange(last) > 0.0 &&
    this->AreJoined(a, aside, { this->PredictAlong(a, aside), this->PredictAlong(aside, a) });
  return hasAside ? Invert(this->PredictInverse(last, a, b)) : this->PredictAlong(a, b);
}

// The same from the two returns alone, on a plane at a right angle to the plane of their beams.
double DepthSteps::PredictAlong(const Beam& a, const Beam& b) const
{
  const double at = this->GetRange(a);
  const double before = this->GetRangeBefore({ 2 * a.Turn - b.Turn, 2 * a.Number - b.Number }, a);
  return before == 0.0 ? at : Invert(2.0 * std::cos(this->GetStep(a, b)) / at - 1.0 / before);
}

// Beyond a pole of a full circle, returns the nearer range of the opposite turns beside the pole.
double DepthSteps::GetRangeBefore(const Beam& before, const Beam& a) const
{
  const bool isBeyond = before.Number < 0 || before.Number >= this->Grid.GetNumberOfBeams();
  if (!isBeyond || !this->Grid.Contains(a) || !this->Grid.IsPole(a.Number) ||
    !this->Grid.IsClosed())
  {
    return this->GetRange(before);
  }
  const int beside = 2 * a.Number - before.Number;
  const int turns = this->Grid.GetNumberOfTurns();
  return std::min(this->GetRange({ a.Turn + turns / 2, beside }),
    this->GetRange({ a.Turn + turns - turns / 2, beside }));
}

ScanGrid::Beam DepthSteps::GetTowardsHorizon(const Beam& beam) const
{
  const bool isNext = this->Grid.GetElevation(beam.Number) * this->Grid.GetFanStep() <= 0.0;
  return { beam.Turn, beam.Number + (isNext ? 1 : -1) };
}

// From the plane through three returns.
double DepthSteps::PredictInverse(const Beam& last, const Beam& a, const Beam& b) const
{
  const auto get = [&](const Beam& beam) -> const Vector&
  { return this->Grid.GetPoints()[this->Grid.GetReturn(beam)]; };
  const Vector& at = get(a);
  const Vector normal = Cross(get(last) - at, get(this->GetTowardsHorizon(a)) - at);
  return Dot(normal, this->Grid.GetDirection({ 1.0 * b.Turn, 1.0 * b.Number })) / Dot(normal, at);
}

bool DepthSteps::AreJoined(const Beam& a, const Beam& b) const
{
  return this->AreJoined(a, b, { this->Predict(a, b), this->Predict(b, a) });
}

bool DepthSteps::AreJoined(const Beam& a, const Beam& b, const Predictions& predictions) const
{
  const auto& [ofB, ofA] = predictions;
  const auto isFlat = [&](double range, const Beam& beam)
  { return this->Noise == 0.0 && std::abs(range - this->GetRange(beam)) <= Flatness; };
  return this->HaveReturned(a, b) && this->GetStep(a, b) < vtkMath::Pi() &&
    (std::abs(this->GetRange(a) - this->GetRange(b)) <= this->DepthStep ||
      (isFlat(ofB, b) && isFlat(ofA, a)));
}

// How far noise in all three returns can move the prediction of b from a, and b itself.
double DepthSteps::GetError(const Beam& a, const Beam& b) const
{
  const double range = this->GetRange(a);
  const double before = this->GetRangeBefore(GetBefore(a, b), a);
  const double predicted = this->Predict(a, b);
  if (this->Noise == 0.0 || before == 0.0)
  {
    return 2.0 * this->Noise;
  }
  const double shares = 2.0 / (range * range) + 1.0 / (before * before);
  return this->Noise * (1.0 + predicted * predicted * shares);
}

bool DepthSteps::AreApart(const Beam& a, const Beam& b) const
{
  const auto endsBefore = [&](const Beam& from, const Beam& to)
  {
    const double towards = this->GetRange(to) > this->GetRange(from) ? 1.0 : -1.0;
    const double least = this->GetTolerance(a, b) + this->GetError(from, to);
    const std::vector<double> predictions = this->PredictAnyTilt(from, to);
    return std::all_of(predictions.begin(), predictions.end(),
      [&](double range) { return towards * (this->GetRange(to) - range) > least; });
  };
  return this->HaveReturned(a, b) && !this->AreJoined(a, b) && endsBefore(a, b) && endsBefore(b, a);
}

// With the tilt of an upright plane, and with that towards the return beside a, which need not be
// on the same plane.
std::vector<double> DepthSteps::PredictAnyTilt(const Beam& a, const Beam& b) const
{
  std::vector<double> predictions = { this->PredictAlong(a, b) };
  const Beam last = GetBefore(a, b);
  if (a.Turn != b.Turn && this->Grid.Contains(a) &&
    this->HaveReturned(last, this->GetTowardsHorizon(a)))
  {
    predictions.push_back(Invert(this->PredictInverse(last, a, b)));
  }
  return predictions;
}
