// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The steps of TrueSteps that the returns show.
#include "LocalMap/TrueSteps.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace
{
// A return lies on the plane of a triangle, metres.
constexpr double MaximumDistance = 1e-4;
} // namespace

TrueSteps::Plane TrueSteps::GetPlane(const Beam& beam) const
{
  vtkNew<vtkIdList> ids;
  this->Scene->GetCellPoints(this->Grid.GetCellId(this->Grid.GetReturn(beam)), ids);
  std::array<Vector, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    this->Scene->GetPoint(ids->GetId(i), corners[i].data());
    corners[i] = corners[i] - this->Grid.GetSensor();
  }
  const Vector normal = Normalize(Cross(corners[1] - corners[0], corners[2] - corners[0]));
  return { normal, Dot(normal, corners[0]) };
}

bool TrueSteps::IsOn(const Plane& plane, const Beam& beam) const
{
  if (!this->Grid.Contains(beam) || this->Grid.GetReturn(beam) == ScanGrid::NoReturn)
  {
    return false;
  }
  const Vector& point = this->Grid.GetPoints()[this->Grid.GetReturn(beam)];
  return std::abs(Dot(plane.Normal, point) - plane.Offset) < MaximumDistance;
}

// Whether the returns from `last` away from `other` show the plane of the triangle at `last`.
bool TrueSteps::IsPlane(const Beam& last, const Beam& other) const
{
  const Plane plane = this->GetPlane(last);
  const int turns = last.Turn - other.Turn;
  const int beams = last.Number - other.Number;
  const auto isOn = [&](int along, int beside) {
    return this->IsOn(plane, { last.Turn + along * turns, last.Number + along * beams + beside });
  };
  // Elevations grow with the numbers of beams.
  const int beside = this->Grid.GetElevation(last.Number) > 0.0 ? -1 : 1;
  return isOn(1, 0) && isOn(2, 0) && (turns == 0 || (isOn(0, beside) && isOn(1, beside)));
}

// How far behind the return of `to` the plane at `from` meets the beam, metres; infinite if it
// does not.
double TrueSteps::GetGap(const Beam& from, const Beam& to) const
{
  const Plane plane = this->GetPlane(from);
  const Vector& point = this->Grid.GetPoints()[this->Grid.GetReturn(to)];
  const double range = GetLength(point);
  const double met = range * plane.Offset / Dot(plane.Normal, point);
  return met > 0.0 ? met - range : std::numeric_limits<double>::infinity();
}

// Whether the plane at `from` misses the return of `to`, although the last two returns of the plane
// and that of `to` have errors. The plane of two inverse ranges w0 and w1 goes on at 2 w0 - w1 if
// the beams are close together.
bool TrueSteps::IsCertain(const Beam& from, const Beam& to, double error) const
{
  const auto getInverse = [this](const Beam& beam)
  { return 1.0 / this->Grid.GetRange(this->Grid.GetReturn(beam)); };
  const double last = getInverse(from);
  const double before = getInverse({ 2 * from.Turn - to.Turn, 2 * from.Number - to.Number });
  const double other = getInverse(to);
  const Plane plane = this->GetPlane(from);
  const Vector& point = this->Grid.GetPoints()[this->Grid.GetReturn(to)];
  const double met = Dot(plane.Normal, point) * other / plane.Offset;
  return std::abs(met - other) >
    error * std::hypot(2.0 * last * last, before * before, other * other);
}

std::vector<TrueSteps::Step> TrueSteps::FindShown(double margin, double error) const
{
  std::vector<Step> shown;
  std::copy_if(this->Steps.begin(), this->Steps.end(), std::back_inserter(shown),
    [&](const Step& step)
    {
      const double atNext = this->GetGap(step.From, step.Next);
      const double atFrom = this->GetGap(step.Next, step.From);
      return this->IsPlane(step.From, step.Next) && this->IsPlane(step.Next, step.From) &&
        this->IsCertain(step.From, step.Next, error) &&
        this->IsCertain(step.Next, step.From, error) &&
        ((atNext > margin && atFrom < -margin) || (atNext < -margin && atFrom > margin));
    });
  return shown;
}
