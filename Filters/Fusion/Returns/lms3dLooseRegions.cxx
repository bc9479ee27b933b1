// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dLooseRegions.h"

#include "Fusion/Planes/lms3dBlockBoxes.h"
#include "Fusion/Planes/lms3dCoveringPlanes.h"
#include "Fusion/Planes/lms3dFoundPlanes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <utility>
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

// Adds the loose regions for which a plane may have changed the verdict.
void AddToJudge(
  const lms3dFusedPlanes& planes, std::size_t number, int revision, std::vector<int>& found)
{
  const lms3dFusedPlane& plane = planes[number];
  lms3dBlockBoxes changed;
  for (const lms3dFusedTile& tile : plane.Tiles)
  {
    const bool isNew = tile.Revision >= revision;
    std::for_each(tile.Blocks.begin(), isNew ? tile.Blocks.end() : tile.Blocks.begin(),
      [&](int block) { changed.Add(plane, block); });
  }
  changed.FindPlanesNear(planes, LargestDistance * planes.GetMaximumError(), IsLoose, found);
  if (plane.Raster.HasForgotten() && IsLoose(plane))
  {
    found.push_back(static_cast<int>(number));
  }
}

// The loose regions for which the verdict may have changed, in order.
std::vector<int> FindToJudge(const lms3dFusedPlanes& planes, int revision)
{
  return lms3dFindForPlanes(planes,
    [&](std::size_t number, std::vector<int>& found)
    { AddToJudge(planes, number, revision, found); });
}

// Adds the planes that cover the returns of a region, -1 for none. `covering` has the planes for
// its first returns.
void FindCovering(const lms3dFusedPlanes& planes, int number, std::vector<int>& covering)
{
  const std::vector<lms3dMappedReturn>& returns = planes[number].Returns;
  covering.reserve(returns.size());
  lms3dCoveringPlanes search(planes);
  for (std::size_t i = covering.size(); i < returns.size(); ++i)
  {
    covering.push_back(search.Find(returns[i], { number }, planes.GetMaximumError()));
  }
}

bool HasAnyGone(const lms3dFusedPlanes& planes, const std::vector<int>& numbers)
{
  return std::any_of(numbers.begin(), numbers.end(),
    [&](int number) { return number >= 0 && planes[number].HasGone; });
}

// A region that has got too many returns to keep them stays. What was found before regions went
// holds if none of the planes has gone. Returns that the region has got since are its last ones.
void DropIfNeedless(lms3dFusedPlanes& planes, int number, std::vector<int> covering)
{
  const lms3dFusedPlane& plane = planes[number];
  if (!plane.IsWeak)
  {
    return;
  }
  if (HasAnyGone(planes, covering))
  {
    covering.clear();
  }
  FindCovering(planes, number, covering);
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

// The threads divide planes, then the regions that are judged.
void lms3dDropLooseRegions(lms3dFusedPlanes& planes, int revision)
{
  const std::vector<int> numbers = FindToJudge(planes, revision);
  std::vector<std::vector<int>> covering(numbers.size());
  tbb::parallel_for(std::size_t{ 0 }, numbers.size(),
    [&](std::size_t i)
    {
      planes[numbers[i]].DropForgotten();
      FindCovering(planes, numbers[i], covering[i]);
    });
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    DropIfNeedless(planes, numbers[i], std::move(covering[i]));
  }
}
