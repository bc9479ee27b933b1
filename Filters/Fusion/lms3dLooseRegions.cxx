// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dLooseRegions.h"

#include "Fusion/lms3dBlockBoxes.h"
#include "Fusion/lms3dCoveringPlanes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
// Bounds: how far a block may be from the box of a region with a return that it covers. The return
// is within one bound and a cell of both.
constexpr double LargestDistance = 3.0;

bool IsLoose(const lms3dFusedPlane& plane)
{
  return !plane.Verbatim.empty() && !plane.Returns.empty();
}

// The loose regions for which the verdict may have changed, in order.
std::vector<int> FindToJudge(const lms3dFusedPlanes& planes, int revision)
{
  std::vector<int> found;
  for (std::size_t i = 0; i < planes.GetSize(); ++i)
  {
    const lms3dFusedPlane& plane = planes[i];
    lms3dBlockBoxes changed;
    for (const lms3dFusedTile& tile : plane.Tiles)
    {
      const bool isNew = tile.Revision >= revision;
      std::for_each(tile.Blocks.begin(), isNew ? tile.Blocks.end() : tile.Blocks.begin(),
        [&](int number) { changed.Add(plane, number); });
    }
    changed.FindPlanesNear(planes, LargestDistance * planes.GetMaximumError(), IsLoose, found);
    if (plane.Raster.HasForgotten() && IsLoose(plane))
    {
      found.push_back(static_cast<int>(i));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void DropIfNeedless(lms3dFusedPlanes& planes, int number)
{
  lms3dFusedPlane& plane = planes[number];
  plane.DropForgotten();
  std::vector<int> covering;
  covering.reserve(plane.Returns.size());
  lms3dCoveringPlanes search(planes);
  for (const lms3dMappedReturn& mapped : plane.Returns)
  {
    covering.push_back(search.Find(mapped, { number }, planes.GetMaximumError()));
  }
  const auto open = static_cast<std::size_t>(std::count(covering.begin(), covering.end(), -1));
  if (open >= plane.CountTriangles())
  {
    return;
  }
  const std::vector<lms3dMappedReturn> returns = plane.Returns;
  planes.Clear(number);
  for (std::size_t i = 0; i < returns.size(); ++i)
  {
    planes.AddBesideOrFacet(covering[i], returns[i]);
  }
}
} // namespace

void lms3dDropLooseRegions(lms3dFusedPlanes& planes, int revision)
{
  for (const int number : FindToJudge(planes, revision))
  {
    DropIfNeedless(planes, number);
  }
}
