// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatches.h"

#include <cstddef>

std::vector<int> lms3dPatches::CountMembers(const lms3dBeamSphere& sphere) const
{
  std::vector<int> counts(this->Patches.size(), 0);
  for (std::size_t first = 0; first < this->Labels.size();)
  {
    const std::int32_t label = this->Labels[first];
    std::size_t end = first + 1;
    while (end < this->Labels.size() && this->Labels[end] == label)
    {
      ++end;
    }
    if (label >= 0)
    {
      counts[label] += static_cast<int>(end - first);
    }
    first = end;
  }
  for (std::size_t index = 0; sphere.HasFilled() && index < this->Labels.size(); ++index)
  {
    if (this->Labels[index] >= 0 && sphere.IsFilled(static_cast<std::int32_t>(index)))
    {
      --counts[this->Labels[index]];
    }
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
