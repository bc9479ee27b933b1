// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dWeakPlanes.h"

#include <algorithm>
#include <vector>

namespace
{
// The share of a weak plane's returns that other planes must explain to take its place.
constexpr double DissolvedShare = 0.9;
} // namespace

void lms3dDissolveWeakPlanes(lms3dFusedPlanes& planes)
{
  const std::size_t end = planes.GetSize();
  for (std::size_t i = 0; i < end; ++i)
  {
    lms3dFusedPlane& plane = planes[i];
    if (!plane.IsWeak || plane.Raster.GetMarked().empty() || plane.Returns.empty())
    {
      continue;
    }
    std::vector<int> others = planes.FindPlanesNear(plane.Returns, end);
    others.erase(std::remove(others.begin(), others.end(), static_cast<int>(i)), others.end());
    if (!planes.ShowShare(DissolvedShare, others, plane.Returns))
    {
      continue;
    }
    const std::vector<lms3dMappedReturn> returns = plane.Returns;
    plane.Clear();
    for (const lms3dMappedReturn& mapped : returns)
    {
      if (!planes.AddToPlanes(others, mapped))
      {
        planes.AddFacet(mapped);
      }
    }
  }
}
