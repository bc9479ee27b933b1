// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dReturnGroups.h"

#include "Fusion/Scans/lms3dReturnPlane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace
{
// As a share of the bound: how far a return that lies on a plane may be from it.
constexpr double NearShare = 0.25;
// The fewest returns of a group.
constexpr std::size_t SmallestCount = 3;
constexpr std::size_t LargestNumberOfGroups = 8;
constexpr std::size_t Trials = 64;
// More returns are judged by a part of them, at least half of this number.
constexpr std::size_t SufficientCount = 300;
constexpr int Fits = 2;
// Prime numbers: the steps between the returns of a trial, near in the order of the beams, and any.
constexpr std::size_t StartStep = 7919;
constexpr std::array<std::size_t, 4> NearSteps = { 1, 3, 11, 37 };
constexpr std::size_t FarStep = 104729;

using Plane = lms3dReturnPlane;
using Numbers = std::vector<int>;

class Grouping
{
public:
  Grouping(const std::vector<lms3dMappedReturn>& returns, double bound)
    : Returns(returns)
    , Bound(bound)
  {
    for (std::size_t i = 0; i < returns.size(); ++i)
    {
      this->Left.push_back(static_cast<int>(i));
    }
  }

  std::vector<lms3dReturnGroup> Find()
  {
    std::vector<lms3dReturnGroup> groups;
    while (this->Left.size() >= SmallestCount && groups.size() < LargestNumberOfGroups)
    {
      const std::optional<Plane> best = this->FindBest();
      if (!best)
      {
        break;
      }
      groups.push_back(this->TakeGroup(*best));
    }
    return groups;
  }

private:
  const lms3dMappedReturn& Get(std::size_t i) const
  {
    return this->Returns[this->Left[i % this->Left.size()]];
  }

  std::optional<Plane> FindBest() const
  {
    std::optional<Plane> best;
    std::size_t most = SmallestCount - 1;
    const std::size_t step = this->Left.size() / SufficientCount + 1;
    const std::size_t trials = std::min(Trials, 2 * this->Left.size());
    for (std::size_t trial = 0; trial < trials; ++trial)
    {
      std::optional<Plane> plane = this->MakePlane(trial);
      for (int fit = 0; plane && fit <= Fits; ++fit)
      {
        const Numbers on = this->FindNear(*plane, step);
        if (on.size() > most)
        {
          best = plane;
          most = on.size();
        }
        const bool isWorth = on.size() >= SmallestCount && 4 * on.size() >= most;
        plane = isWorth && fit < Fits ? this->Fit(on) : std::nullopt;
      }
    }
    return best;
  }

  /// The plane through three returns.
  std::optional<Plane> MakePlane(std::size_t trial) const
  {
    const std::size_t first = trial * StartStep;
    const std::size_t near = NearSteps[trial % NearSteps.size()];
    const lms3dMappedReturn& a = this->Get(first);
    const lms3dMappedReturn& b = this->Get(first + near);
    const lms3dMappedReturn& c =
      this->Get(first + (trial % 2 == 0 ? 2 * near + 1 : trial * FarStep));
    const lms3dVector cross =
      lms3dCross(lms3dSubtract(b.Point, a.Point), lms3dSubtract(c.Point, a.Point));
    const double length = lms3dGetLength(cross);
    if (!(length > this->Bound * this->Bound))
    {
      return this->Fit(
        { this->Left[first % this->Left.size()], this->Left[(first + near) % this->Left.size()] });
    }
    const lms3dVector normal =
      lms3dScale(cross, (lms3dDot(cross, a.Direction) > 0.0 ? -1.0 : 1.0) / length);
    return Plane{ a.Point, normal };
  }

  /// One out of `step` returns is looked at.
  Numbers FindNear(const Plane& plane, std::size_t step) const
  {
    Numbers near;
    for (std::size_t i = 0; i < this->Left.size(); i += step)
    {
      if (plane.Explains(this->Get(i), NearShare * this->Bound))
      {
        near.push_back(this->Left[i]);
      }
    }
    return near;
  }

  std::optional<Plane> Fit(const Numbers& numbers) const
  {
    return lms3dFitReturns(this->Returns, numbers, NearShare * this->Bound);
  }

  lms3dReturnGroup TakeGroup(const Plane& plane)
  {
    lms3dReturnGroup group = { plane.Centre, plane.Normal, 0.0, {} };
    Numbers left;
    double squares = 0.0;
    double count = 0.0;
    for (const int i : this->Left)
    {
      if (!plane.Explains(this->Returns[i], this->Bound))
      {
        left.push_back(i);
        continue;
      }
      group.Returns.push_back(i);
      const double height = plane.GetHeight(this->Returns[i].Point);
      if (std::abs(height) <= NearShare * this->Bound)
      {
        squares += height * height;
        count += 1.0;
      }
    }
    group.Deviation = std::sqrt(squares / std::max(1.0, count));
    this->Left = left;
    return group;
  }

  const std::vector<lms3dMappedReturn>& Returns;
  const double Bound;
  /// The returns without a group, in order.
  Numbers Left;
};
} // namespace

std::vector<lms3dReturnGroup> lms3dGroupReturns(
  const std::vector<lms3dMappedReturn>& returns, double bound)
{
  return Grouping(returns, bound).Find();
}
