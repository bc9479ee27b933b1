// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchBorders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The noise that a plane explains, in standard deviations.
constexpr double ExplainedDeviations = 4.0;
constexpr int MovingPasses = 3;
constexpr int LargestSpike = 8;
// How far off a spike may be, in bounds and in standard deviations of the noise.
constexpr double SpikeInBounds = 1.5;
constexpr double SpikeInDeviations = 5.0;
} // namespace

lms3dPatchBorders::lms3dPatchBorders(
  const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , MaximumError(maximumError)
  , Noise(noise)
{
}

template <typename Visitor>
void lms3dPatchBorders::ForJoinedNeighbors(Place place, const Visitor& visit) const
{
  for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
  {
    if (this->Sphere.HasNeighbor(place, side) && this->Sphere.IsJoined(place, side))
    {
      visit(this->Sphere.GetNeighbor(place, side));
    }
  }
}

double lms3dPatchBorders::GetDeviation(Place place, int patch) const
{
  const double inverse =
    this->Patches.Patches[patch].Plane.GetInverseRange(this->Sphere.GetDirection(place));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(place) - 1.0 / inverse)
                       : std::numeric_limits<double>::infinity();
}

void lms3dPatchBorders::SetLabel(Place place, std::int32_t label)
{
  const int row = this->Sphere.GetRow(place);
  if (!this->Sphere.IsPoleRow(row))
  {
    this->Patches.Labels[place] = label;
    return;
  }
  for (int column = 0; column < this->Sphere.GetNumberOfColumns(); ++column)
  {
    this->Patches.Labels[this->Sphere.GetPlace(column, row)] = label;
  }
}

// The places on both sides of all borders.
std::vector<lms3dPatchBorders::Place> lms3dPatchBorders::FindBorder() const
{
  const std::vector<std::int32_t>& labels = this->Patches.Labels;
  std::vector<Place> border;
  const auto look = [&](Place place, int side)
  {
    const Place other = this->Sphere.GetNeighbor(place, side);
    if (labels[place] != labels[other] && this->Sphere.IsJoined(place, side))
    {
      border.push_back(place);
      border.push_back(other);
    }
  };
  const int rows = this->Sphere.GetNumberOfRows();
  for (Place start = 0; start < this->Sphere.GetNumberOfPlaces(); start += rows)
  {
    for (Place place = start; place < start + rows; ++place)
    {
      look(place, lms3dBeamSphere::Right);
      if (place + 1 < start + rows)
      {
        look(place, lms3dBeamSphere::Up);
      }
    }
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

void lms3dPatchBorders::Move()
{
  std::vector<Place> border = this->FindBorder();
  for (int pass = 0; pass < MovingPasses; ++pass)
  {
    std::vector<Place> moved;
    for (Place place : border)
    {
      if (this->MoveToBestNeighbor(place))
      {
        this->ForJoinedNeighbors(place, [&](Place other) { moved.push_back(other); });
      }
    }
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    border = moved;
  }
}

bool lms3dPatchBorders::MoveToBestNeighbor(Place place)
{
  const std::int32_t own = this->Patches.Labels[place];
  std::int32_t best = own;
  this->ForJoinedNeighbors(place,
    [&](Place other)
    {
      const std::int32_t label = this->Patches.Labels[other];
      if (label != best && label != own && this->IsBetter(place, label, best))
      {
        best = label;
      }
    });
  if (best != own)
  {
    this->SetLabel(place, best);
  }
  return best != own;
}

// Where both planes explain a return, noise must not decide, but the side of their crease that it
// lies on.
bool lms3dPatchBorders::IsBetter(Place place, std::int32_t label, std::int32_t than) const
{
  const double deviation = this->GetDeviation(place, label);
  const double other = this->GetDeviation(place, than);
  const double explained =
    std::max(lms3dPatches::MergedShare * this->MaximumError, ExplainedDeviations * this->Noise);
  if (std::max(deviation, other) <= explained)
  {
    const lms3dPatches::Patch& a = this->Patches.Patches[label];
    const lms3dPatches::Patch& b = this->Patches.Patches[than];
    const lms3dVector across = lms3dSubtract(a.Plane.Q, b.Plane.Q);
    const double sideOfA = lms3dDot(across, a.Fit.GetCenter());
    const double sideOfB = lms3dDot(across, b.Fit.GetCenter());
    const double side = lms3dDot(across, this->Sphere.GetDirection(place));
    if (sideOfA * sideOfB < 0.0)
    {
      return side * sideOfA > 0.0;
    }
  }
  return deviation < other;
}

void lms3dPatchBorders::TakeSpikes()
{
  const std::vector<int> counts = this->Patches.CountMembers(this->Sphere);
  std::vector<std::vector<Place>> members(counts.size());
  for (Place place = 0; place < this->Sphere.GetNumberOfPlaces(); ++place)
  {
    const std::int32_t label = this->Patches.Labels[place];
    if (label >= 0 && counts[label] <= LargestSpike && !this->Sphere.IsRepeated(place))
    {
      members[label].push_back(place);
    }
  }
  for (const std::vector<Place>& spike : members)
  {
    const int around = spike.empty() ? -1 : this->FindSurroundings(spike);
    for (Place place : spike)
    {
      if (around >= 0)
      {
        this->SetLabel(place, around);
      }
    }
  }
}

// The patch that most joined neighbours belong to, or -1 where that is too far off.
int lms3dPatchBorders::FindSurroundings(const std::vector<Place>& members) const
{
  const std::int32_t own = this->Patches.Labels[members.front()];
  std::vector<std::int32_t> labels;
  for (Place place : members)
  {
    this->ForJoinedNeighbors(place,
      [&](Place other)
      {
        if (this->Patches.Labels[other] != own)
        {
          labels.push_back(this->Patches.Labels[other]);
        }
      });
  }
  std::sort(labels.begin(), labels.end());
  int best = -1;
  std::ptrdiff_t most = 0;
  for (auto first = labels.begin(); first != labels.end();)
  {
    const auto last = std::upper_bound(first, labels.end(), *first);
    if (last - first > most)
    {
      most = last - first;
      best = *first;
    }
    first = last;
  }
  const double farthest =
    std::max(SpikeInBounds * this->MaximumError, SpikeInDeviations * this->Noise);
  const bool isNear = best >= 0 && 2 * most >= static_cast<std::ptrdiff_t>(labels.size()) &&
    std::all_of(members.begin(), members.end(),
      [&](Place place) { return this->GetDeviation(place, best) <= farthest; });
  return isNear ? best : -1;
}
