// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dPatchMerger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
// The share of the bound that a merged plane may use up; the borders need the rest.
constexpr double MergingShare = 0.8;
// The noise that a plane explains, in standard deviations.
constexpr double ExplainedDeviations = 4.0;
// Where one patch is so many times larger, its plane is the joint plane.
constexpr double MuchLarger = 16.0;
constexpr int MergingPasses = 4;
constexpr int MovingPasses = 3;
constexpr int LargestSpike = 8;
// How far off a spike may be, in bounds and in standard deviations of the noise.
constexpr double SpikeInBounds = 1.5;
constexpr double SpikeInDeviations = 5.0;
} // namespace

lms3dPatchMerger::lms3dPatchMerger(
  const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , MaximumError(maximumError)
  , Noise(noise)
  , Parents(patches.Patches.size())
{
  std::iota(this->Parents.begin(), this->Parents.end(), 0);
}

template <typename Visitor>
void lms3dPatchMerger::ForJoinedNeighbors(Place place, const Visitor& visit) const
{
  const int row = this->Sphere.GetRow(place);
  for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
  {
    const bool isEdge = (side == lms3dBeamSphere::Down && row == 0) ||
      (side == lms3dBeamSphere::Up && row + 1 == this->Sphere.GetNumberOfRows());
    if (!isEdge && this->Sphere.IsJoined(place, side))
    {
      visit(this->Sphere.GetNeighbor(place, side));
    }
  }
}

std::vector<lms3dPatchMerger::Pair> lms3dPatchMerger::FindNeighbors() const
{
  const std::vector<std::int32_t>& labels = this->Patches.Labels;
  std::vector<Pair> pairs;
  const auto add = [&](Place place, int side)
  {
    const std::int32_t a = labels[place];
    const std::int32_t b = labels[this->Sphere.GetNeighbor(place, side)];
    if (a != b && this->Sphere.IsJoined(place, side))
    {
      pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  };
  const int rows = this->Sphere.GetNumberOfRows();
  for (int column = 0; column < this->Sphere.GetNumberOfColumns(); ++column)
  {
    for (int row = 0; row < rows; ++row)
    {
      const Place place = this->Sphere.GetPlace(column, row);
      add(place, lms3dBeamSphere::Right);
      if (row + 1 < rows)
      {
        add(place, lms3dBeamSphere::Up);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

int lms3dPatchMerger::FindRoot(int patch)
{
  while (this->Parents[patch] != patch)
  {
    this->Parents[patch] = this->Parents[this->Parents[patch]];
    patch = this->Parents[patch];
  }
  return patch;
}

void lms3dPatchMerger::Merge()
{
  const std::vector<Pair> pairs = this->FindNeighbors();
  bool hasMerged = true;
  for (int pass = 0; pass < MergingPasses && hasMerged; ++pass)
  {
    hasMerged = false;
    for (const Pair& pair : pairs)
    {
      int large = this->FindRoot(pair.first);
      int small = this->FindRoot(pair.second);
      const auto size = [&](int patch)
      { return this->Patches.Patches[patch].Fit.GetNumberOfReturns(); };
      if (size(large) < size(small))
      {
        std::swap(large, small);
      }
      hasMerged |= large != small && this->TryToMerge(large, small);
    }
  }
  this->WriteLabels();
}

bool lms3dPatchMerger::TryToMerge(int large, int small)
{
  const lms3dPatches::Patch& a = this->Patches.Patches[large];
  const lms3dPatches::Patch& b = this->Patches.Patches[small];
  if (this->Explains(a.Plane, b))
  {
    this->Join(large, small, a.Plane);
    return true;
  }
  if (a.Fit.GetNumberOfReturns() > MuchLarger * b.Fit.GetNumberOfReturns())
  {
    return false;
  }
  lms3dPlaneFit fit = a.Fit;
  fit.Add(b.Fit);
  const lms3dPlane plane = fit.GetPlane();
  if (this->Explains(plane, b) && this->Explains(plane, a))
  {
    this->Join(large, small, plane);
    return true;
  }
  return false;
}

bool lms3dPatchMerger::Explains(const lms3dPlane& plane, const lms3dPatches::Patch& patch) const
{
  const double tolerance = MergingShare * this->MaximumError;
  return std::all_of(patch.Spans.begin(), patch.Spans.end(),
    [&](const lms3dPatches::Span& span)
    {
      const int column = this->Sphere.GetColumn(span.First);
      const Place start = this->Sphere.GetPlace(column, 0);
      const lms3dColumnPlane inColumn(plane, this->Sphere, column);
      for (Place place = span.First; place <= span.Last; ++place)
      {
        const int row = place - start;
        if (!lms3dIsWithin(this->Sphere.GetRange(place),
              inColumn.GetInverseRange(
                this->Sphere.GetCosines()[row], this->Sphere.GetSines()[row]),
              tolerance))
        {
          return false;
        }
      }
      return true;
    });
}

void lms3dPatchMerger::Join(int large, int small, const lms3dPlane& plane)
{
  lms3dPatches::Patch& a = this->Patches.Patches[large];
  lms3dPatches::Patch& b = this->Patches.Patches[small];
  a.Plane = plane;
  a.Fit.Add(b.Fit);
  a.Spans.insert(a.Spans.end(), b.Spans.begin(), b.Spans.end());
  b.Spans.clear();
  this->Parents[small] = large;
}

void lms3dPatchMerger::WriteLabels()
{
  for (std::int32_t& label : this->Patches.Labels)
  {
    label = label < 0 ? label : this->FindRoot(label);
  }
}

double lms3dPatchMerger::GetDeviation(Place place, int patch) const
{
  const double inverse =
    this->Patches.Patches[patch].Plane.GetInverseRange(this->Sphere.GetDirection(place));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(place) - 1.0 / inverse)
                       : std::numeric_limits<double>::infinity();
}

void lms3dPatchMerger::SetLabel(Place place, std::int32_t label)
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
std::vector<lms3dPatchMerger::Place> lms3dPatchMerger::FindBorder() const
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

void lms3dPatchMerger::MoveBorders()
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

bool lms3dPatchMerger::MoveToBestNeighbor(Place place)
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
bool lms3dPatchMerger::IsBetter(Place place, std::int32_t label, std::int32_t than) const
{
  const double deviation = this->GetDeviation(place, label);
  const double other = this->GetDeviation(place, than);
  const double explained =
    std::max(MergingShare * this->MaximumError, ExplainedDeviations * this->Noise);
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

void lms3dPatchMerger::TakeSpikes()
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
int lms3dPatchMerger::FindSurroundings(const std::vector<Place>& members) const
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
