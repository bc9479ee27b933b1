// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dWeakPlanes.h"

#include "Fusion/Planes/lms3dBlockBoxes.h"
#include "Fusion/Planes/lms3dFoundPlanes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace
{
// The smallest share of a weak plane's returns that other planes must show to take its place.
constexpr double SmallestShare = 0.5;

/// A weak plane near new surface.
struct WeakPlane
{
  std::size_t Number;
  /// How many returns it has.
  std::size_t Count;
  /// The other planes near its returns, and whether they show enough of these.
  std::vector<int> Others;
  bool IsShown;
};

// The weak planes near surface that the last scan added, in order.
std::vector<int> FindNearNewSurface(const lms3dFusedPlanes& planes)
{
  return lms3dFindForPlanes(planes,
    [&](std::size_t number, std::vector<int>& found)
    {
      const lms3dFusedPlane& plane = planes[number];
      lms3dBlockBoxes grown;
      for (const int block : plane.Raster.GetMarked())
      {
        if (plane.Raster.HasMark(block, lms3dRaster::GREW))
        {
          grown.Add(plane, block);
        }
      }
      grown.FindPlanesNear(
        planes, planes.GetMaximumError(),
        [](const lms3dFusedPlane& near) { return near.IsWeak && !near.Returns.empty(); }, found);
    });
}

// The share of a weak plane's returns that others must show. Facets for the other returns are then
// fewer than the plane's triangles.
double GetNeededShare(const lms3dFusedPlane& plane)
{
  const double saved = static_cast<double>(plane.CountTriangles()) - 1.0;
  const double returns = std::max(1.0, static_cast<double>(plane.Returns.size()));
  return std::clamp(1.0 - saved / returns, SmallestShare, 1.0);
}

WeakPlane Judge(const lms3dFusedPlanes& planes, std::size_t number, std::size_t end)
{
  const std::vector<lms3dMappedReturn>& returns = planes[number].Returns;
  std::vector<int> others = planes.FindPlanesNear(returns, end);
  others.erase(std::remove(others.begin(), others.end(), static_cast<int>(number)), others.end());
  const bool isShown = planes.ShowShare(GetNeededShare(planes[number]), others, returns);
  return { number, returns.size(), std::move(others), isShown };
}

/// Judges some weak planes at once.
std::vector<WeakPlane> JudgeAll(const lms3dFusedPlanes& planes, const std::vector<int>& numbers)
{
  std::vector<WeakPlane> weak(numbers.size());
  tbb::parallel_for(std::size_t{ 0 }, weak.size(),
    [&](std::size_t i)
    { weak[i] = Judge(planes, static_cast<std::size_t>(numbers[i]), planes.GetSize()); });
  return weak;
}
} // namespace

// What was judged at once holds as long as none of the other planes has gone, and no return has
// been added.
void lms3dDissolveWeakPlanes(lms3dFusedPlanes& planes)
{
  const std::size_t end = planes.GetSize();
  std::set<int> gone;
  const std::vector<int> weakPlanes = FindNearNewSurface(planes);
  for (const int number : weakPlanes)
  {
    planes[number].DropForgotten();
  }
  for (const WeakPlane& judged : JudgeAll(planes, weakPlanes))
  {
    lms3dFusedPlane& plane = planes[judged.Number];
    const bool isValid = judged.Count == plane.Returns.size() &&
      std::none_of(judged.Others.begin(), judged.Others.end(),
        [&](int other) { return gone.count(other) > 0; });
    if (!plane.IsWeak || (isValid && !judged.IsShown))
    {
      continue;
    }
    const WeakPlane weak = isValid ? judged : Judge(planes, judged.Number, end);
    if (!weak.IsShown)
    {
      continue;
    }
    const std::vector<lms3dMappedReturn> returns = plane.Returns;
    planes.Clear(static_cast<int>(judged.Number));
    gone.insert(static_cast<int>(judged.Number));
    for (const lms3dMappedReturn& mapped : returns)
    {
      if (!planes.AddToPlanes(weak.Others, mapped))
      {
        planes.AddFacet(mapped);
      }
    }
  }
}
