// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/DepthSteps.h"

#include "Fixtures/TriangleTree.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
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

// The range of b if the surface continues as from the beam before a to a: infinite if the surface does not
// reach b, the range of a if there is no return before.
double DepthSteps::Predict(const Beam& a, const Beam& b) const
{
  const Beam last = { 2 * a.Turn - b.Turn, 2 * a.Number - b.Number };
  if (!this->Grid.Contains(a))
  {
    return this->PredictAlong(a, b);
  }
  const Beam aside = this->GetTowardsHorizon(a);
  const bool hasAside = a.Turn != b.Turn && this->GetRange(last) > 0.0 &&
    this->AreJoined(a, aside,
      { this->PredictAlong(a, aside), this->PredictAlong(aside, a),
        this->PredictAlong(GetBefore(a, aside), a),
        this->PredictAlong(GetBefore(aside, a), aside) });
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
  return this->AreJoined(a, b,
    { this->Predict(a, b), this->Predict(b, a), this->Predict(GetBefore(a, b), a),
      this->Predict(GetBefore(b, a), b) });
}

bool DepthSteps::AreJoined(const Beam& a, const Beam& b, const Predictions& predictions) const
{
  const auto& [ofB, ofA, ofAFromBefore, ofBFromBefore] = predictions;
  const double tolerance = this->GetTolerance(a, b);
  const auto isNear = [&](double range, const Beam& beam)
  { return std::abs(range - this->GetRange(beam)) <= tolerance; };
  const auto reaches = [&](double range, const Beam& beam)
  { return range >= this->GetRange(beam) - tolerance; };
  return this->HaveReturned(a, b) && this->GetStep(a, b) < vtkMath::Pi() &&
    (isNear(this->GetRange(a), b) || isNear(ofB, b) || isNear(ofA, a) ||
      (reaches(ofB, b) && reaches(ofA, a) &&
        (this->GetRange(a) < this->GetRange(b) ? this->IsStraight(a, b, ofAFromBefore)
                                               : this->IsStraight(b, a, ofBFromBefore))));
}

// Whether the two returns before a predict the range of a.
bool DepthSteps::IsStraight(const Beam& a, const Beam& b, double predicted) const
{
  const Beam before = GetBefore(a, b);
  return this->HaveReturned(before, a) && this->GetRange(GetBefore(before, a)) > 0.0 &&
    std::abs(predicted - this->GetRange(a)) <= this->GetTolerance(before, a);
}

bool DepthSteps::AreApart(const Beam& a, const Beam& b) const
{
  const auto endsBefore = [&](const Beam& from, const Beam& to)
  {
    const double towards = this->GetRange(to) > this->GetRange(from) ? 1.0 : -1.0;
    return towards * (this->GetRange(to) - this->Predict(from, to)) > this->GetTolerance(a, b);
  };
  return this->HaveReturned(a, b) && !this->AreJoined(a, b) && endsBefore(a, b) && endsBefore(b, a);
}
