// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatches.h"

std::vector<int> lms3dPatches::CountMembers(const lms3dBeamSphere& sphere) const
{
  std::vector<int> counts(this->Patches.size(), 0);
  for (std::int32_t label : this->Labels)
  {
    if (label >= 0)
    {
      ++counts[label];
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
