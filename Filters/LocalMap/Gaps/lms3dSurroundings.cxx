// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dSurroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
// The number of returns that determine a plane with some redundancy.
constexpr std::size_t MinimumReturns = 5;
constexpr std::size_t MaximumNeighbors = 8;
// The share of the range that is added to a depth step (lms3dDepthStep), and the share of the depth
// step that a plane explains: of returns on both sides of a step, some are farther from their
// plane.
constexpr double RelativeStep = 0.02;
constexpr double StepShare = 1.0 / 3.0;

void RemoveDuplicates(std::vector<int>& places)
{
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

lms3dVector GetPoint(const lms3dMapRay& ray, double range)
{
  return lms3dAdd(ray.Origin, lms3dScale(ray.Direction, range));
}
} // namespace

// Returns false if the group touches the edge of the scan or free space.
bool lms3dSurroundings::Collect(
  const std::vector<int>& group, std::vector<int>& returns, std::vector<int>& hidden) const
{
  returns.clear();
  hidden.clear();
  returns.reserve(MaximumNeighbors * group.size());
  for (int place : group)
  {
    for (int neighbor : this->States.GetNeighbors(place))
    {
      switch (this->States.GetState(neighbor))
      {
        case lms3dBeamStates::Outside:
        case lms3dBeamStates::Free:
          return false;
        case lms3dBeamStates::Returned:
          returns.push_back(neighbor);
          break;
        default:
          hidden.push_back(neighbor);
      }
    }
  }
  RemoveDuplicates(returns);
  return true;
}

bool lms3dSurroundings::HasEnoughReturns(const std::vector<int>& group) const
{
  std::vector<int> returns;
  std::vector<int> hidden;
  return this->Collect(group, returns, hidden) && returns.size() >= MinimumReturns;
}

// Whether a return has one beside it in its fan and one in its turn. The returns are sorted.
bool lms3dSurroundings::HasAngle(const std::vector<int>& returns) const
{
  const auto isReturn = [&](int place)
  { return std::binary_search(returns.begin(), returns.end(), place); };
  return std::any_of(returns.begin(), returns.end(),
    [&](int place)
    {
      const std::array<int, 8> neighbors = this->States.GetNeighbors(place);
      return !this->States.IsPole(place) && (isReturn(neighbors[0]) || isReturn(neighbors[1])) &&
        (isReturn(neighbors[2]) || isReturn(neighbors[3]));
    });
}

double lms3dSurroundings::GetToleranceAt(double range) const
{
  return std::min(this->Tolerance, StepShare * (this->DepthStep + RelativeStep * range));
}

double lms3dSurroundings::GetRange(int place, const lms3dPlane& plane) const
{
  const lms3dMapRay ray = this->States.GetRay(place);
  const double slope = plane.GetInverseRange(ray.Direction);
  return slope == 0.0 ? 0.0 : (1.0 - plane.GetInverseRange(ray.Origin)) / slope;
}

bool lms3dSurroundings::IsOnPlane(int place, const lms3dPlane& plane, double tolerance) const
{
  const double onPlane = this->GetRange(place, plane);
  return onPlane > 0.0 && std::abs(onPlane - this->States.GetRange(place)) <= tolerance;
}

std::optional<lms3dPlane> lms3dSurroundings::FitPlane(const std::vector<int>& group) const
{
  std::vector<int> returns;
  std::vector<int> hidden;
  if (!this->Collect(group, returns, hidden))
  {
    return std::nullopt;
  }
  if (returns.size() < MinimumReturns)
  {
    hidden.insert(hidden.end(), group.begin(), group.end());
    RemoveDuplicates(hidden);
    const std::vector<int> larger = hidden;
    if (!this->Collect(larger, returns, hidden) || returns.size() < MinimumReturns)
    {
      return std::nullopt;
    }
  }
  if (!this->HasAngle(returns))
  {
    return std::nullopt;
  }
  lms3dPlaneFit fit;
  double nearest = this->States.GetRange(returns.front());
  for (int place : returns)
  {
    const double range = this->States.GetRange(place);
    nearest = std::min(nearest, range);
    fit.Add(GetPoint(this->States.GetRay(place), range));
  }
  const lms3dPlane plane = fit.GetPlane();
  const double tolerance = this->GetToleranceAt(nearest);
  const bool isPlane = std::all_of(returns.begin(), returns.end(),
    [&](int place) { return this->IsOnPlane(place, plane, tolerance); });
  return isPlane ? std::optional<lms3dPlane>(plane) : std::nullopt;
}
