// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dLooseRegions.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
void DropIfNeedless(lms3dFusedPlanes& planes, int number)
{
  lms3dFusedPlane& plane = planes[number];
  plane.DropForgotten();
  std::vector<int> covering;
  for (const lms3dMappedReturn& mapped : plane.Returns)
  {
    covering.push_back(planes.FindCovering(mapped, { number }, planes.GetMaximumError()));
  }
  const auto open = static_cast<std::size_t>(std::count(covering.begin(), covering.end(), -1));
  if (open >= plane.CountTriangles())
  {
    return;
  }
  const std::vector<lms3dMappedReturn> returns = plane.Returns;
  plane.Clear();
  for (std::size_t i = 0; i < returns.size(); ++i)
  {
    if (covering[i] >= 0)
    {
      planes.AddBeside(covering[i], returns[i]);
    }
    else
    {
      planes.AddFacet(returns[i]);
    }
  }
}
} // namespace

void lms3dDropLooseRegions(lms3dFusedPlanes& planes)
{
  const std::size_t end = planes.GetSize();
  for (std::size_t i = 0; i < end; ++i)
  {
    if (!planes[i].Verbatim.empty() && !planes[i].Returns.empty())
    {
      DropIfNeedless(planes, static_cast<int>(i));
    }
  }
}
