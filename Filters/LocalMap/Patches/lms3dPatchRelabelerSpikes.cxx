// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchRelabeler.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace
{
// The largest number of returns of a spike.
constexpr int MaximumSpike = 16;
// The largest distance of a spike from the plane around it, in error bounds and in standard
// deviations of the noise.
constexpr double SpikeInBounds = 3.0;
constexpr double SpikeInDeviations = 5.0;
} // namespace

void lms3dPatchRelabeler::AbsorbSpikes()
{
  for (const std::vector<GridIndex>& spike : this->FindSpikes())
  {
    const int around = spike.empty() ? -1 : this->FindSurroundingPatch(spike);
    for (GridIndex index : spike)
    {
      if (around >= 0)
      {
        this->SetLabel(index, around);
      }
    }
  }
}

// The returns of each patch, if these are few; otherwise nothing.
std::vector<std::vector<lms3dPatchRelabeler::GridIndex>> lms3dPatchRelabeler::FindSpikes() const
{
  const std::vector<int> counts = this->Patches.CountMembers(this->Sphere);
  const int columns = this->Sphere.GetNumberOfColumns();
  const int rows = this->Sphere.GetNumberOfRows();
  std::vector<std::vector<GridIndex>> ofColumns(columns);
  tbb::parallel_for(0, columns,
    [&](int column)
    {
      const GridIndex start = this->Sphere.GetIndex(column, 0);
      std::int32_t large = lms3dPatches::None;
      for (GridIndex index = start; index < start + rows; ++index)
      {
        const std::int32_t label = this->Patches.Labels[index];
        if (label < 0 || label == large)
        {
          continue;
        }
        if (counts[label] > MaximumSpike)
        {
          large = label;
        }
        else if (!this->Sphere.IsPoleCopy(index))
        {
          ofColumns[column].push_back(index);
        }
      }
    });
  std::vector<std::vector<GridIndex>> spikes(counts.size());
  for (const std::vector<GridIndex>& ofColumn : ofColumns)
  {
    for (GridIndex index : ofColumn)
    {
      spikes[this->Patches.Labels[index]].push_back(index);
    }
  }
  return spikes;
}

// The patch of most joined neighbours, or -1 if its plane is too far away.
int lms3dPatchRelabeler::FindSurroundingPatch(const std::vector<GridIndex>& members) const
{
  const std::int32_t own = this->Patches.Labels[members.front()];
  std::vector<std::int32_t> labels;
  for (GridIndex index : members)
  {
    this->ForEachJoinedNeighbor(index,
      [&](GridIndex other)
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
      [&](GridIndex index) { return this->GetDeviation(index, best) <= farthest; });
  return isNear ? best : -1;
}
