// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dLooseRegions.h"

#include "Fusion/lms3dBlockBoxes.h"
#include "Fusion/lms3dCoveringPlanes.h"

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

// The planes that cover the returns of a region, -1 for none.
std::vector<int> FindCovering(const lms3dFusedPlanes& planes, int number)
{
  const std::vector<lms3dMappedReturn>& returns = planes[number].Returns;
  std::vector<int> covering;
  covering.reserve(returns.size());
  lms3dCoveringPlanes search(planes);
  for (const lms3dMappedReturn& mapped : returns)
  {
    covering.push_back(search.Find(mapped, { number }, planes.GetMaximumError()));
  }
  return covering;
}

// What was found before regions went holds if none of the planes has gone, and if the region has
// not got returns.
bool IsValid(
  const lms3dFusedPlanes& planes, const lms3dFusedPlane& plane, const std::vector<int>& covering)
{
  return covering.size() == plane.Returns.size() &&
    std::none_of(covering.begin(), covering.end(),
      [&](int other) { return other >= 0 && planes[other].HasGone; });
}

void DropIfNeedless(lms3dFusedPlanes& planes, int number, std::vector<int> covering)
{
  const lms3dFusedPlane& plane = planes[number];
  if (!IsValid(planes, plane, covering))
  {
    covering = FindCovering(planes, number);
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

// The threads divide planes, then the regions that are judged.
void lms3dDropLooseRegions(lms3dFusedPlanes& planes, int revision)
{
  const std::vector<int> numbers = FindToJudge(planes, revision);
  std::vector<std::vector<int>> covering(numbers.size());
  tbb::parallel_for(std::size_t{ 0 }, numbers.size(),
    [&](std::size_t i)
    {
      planes[numbers[i]].DropForgotten();
      covering[i] = FindCovering(planes, numbers[i]);
    });
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    DropIfNeedless(planes, numbers[i], std::move(covering[i]));
  }
}
