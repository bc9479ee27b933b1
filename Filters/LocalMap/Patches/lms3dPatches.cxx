// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatches.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace
{
// The number of labels that a thread counts at least.
constexpr std::size_t LabelsOfTask = 16384;

// Adds how often each label occurs in a part of the grid, without filled entries.
void CountLabels(const lms3dBeamSphere& sphere, const lms3dBeamVector<std::int32_t>& labels,
  const tbb::blocked_range<std::size_t>& part, std::vector<int>& counts)
{
  for (std::size_t first = part.begin(); first < part.end();)
  {
    const std::int32_t label = labels[first];
    std::size_t next = first + 1;
    while (next < part.end() && labels[next] == label)
    {
      ++next;
    }
    if (label >= 0)
    {
      counts[label] += static_cast<int>(next - first);
    }
    first = next;
  }
  const std::uint8_t* const filled = sphere.GetFilled();
  for (std::size_t index = part.begin(); sphere.HasFilled() && index < part.end(); ++index)
  {
    if (filled[index] != 0 && labels[index] >= 0)
    {
      --counts[labels[index]];
    }
  }
}
} // namespace

std::vector<int> lms3dPatches::CountMembers(const lms3dBeamSphere& sphere) const
{
  tbb::enumerable_thread_specific<std::vector<int>> ofThreads(
    [this] { return std::vector<int>(this->Patches.size(), 0); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, this->Labels.size(), LabelsOfTask),
    [&](const tbb::blocked_range<std::size_t>& range)
    { CountLabels(sphere, this->Labels, range, ofThreads.local()); });
  std::vector<int> counts(this->Patches.size(), 0);
  for (const std::vector<int>& ofThread : ofThreads)
  {
    std::transform(
      counts.begin(), counts.end(), ofThread.begin(), counts.begin(), std::plus<int>());
  }
  for (int row : { 0, sphere.GetNumberOfRows() - 1 })
  {
    const std::int32_t label = this->Labels[row];
    if (sphere.IsPoleRow(row) && label >= 0)
    {
      counts[label] -= sphere.GetNumberOfColumns() - 1;
    }
  }
  return counts;
}
