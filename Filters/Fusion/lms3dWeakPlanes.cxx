// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dWeakPlanes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace
{
// The share of a weak plane's returns that other planes must explain to take its place.
constexpr double DissolvedShare = 0.9;
/// A weak plane that the last scan changed.
struct WeakPlane
{
  std::size_t Number;
  /// How many returns it has.
  std::size_t Count;
  /// The other planes near its returns, and whether they show nearly all of these.
  std::vector<int> Others;
  bool IsShown;
};

bool MayGo(const lms3dFusedPlane& plane)
{
  return plane.IsWeak && !plane.Raster.GetMarked().empty() && !plane.Returns.empty();
}

WeakPlane Judge(const lms3dFusedPlanes& planes, std::size_t number, std::size_t end)
{
  const std::vector<lms3dMappedReturn>& returns = planes[number].Returns;
  std::vector<int> others = planes.FindPlanesNear(returns, end);
  others.erase(std::remove(others.begin(), others.end(), static_cast<int>(number)), others.end());
  const bool isShown = planes.ShowShare(DissolvedShare, others, returns);
  return { number, returns.size(), std::move(others), isShown };
}

/// Judges all weak planes at once.
std::vector<WeakPlane> JudgeAll(const lms3dFusedPlanes& planes)
{
  std::vector<WeakPlane> weak;
  for (std::size_t i = 0; i < planes.GetSize(); ++i)
  {
    if (MayGo(planes[i]))
    {
      weak.push_back({ i, 0, {}, false });
    }
  }
  tbb::parallel_for(std::size_t{ 0 }, weak.size(),
    [&](std::size_t i) { weak[i] = Judge(planes, weak[i].Number, planes.GetSize()); });
  return weak;
}
} // namespace

// What was judged at once holds as long as none of the other planes has gone, and no return has
// been added.
void lms3dDissolveWeakPlanes(lms3dFusedPlanes& planes)
{
  const std::size_t end = planes.GetSize();
  const std::vector<WeakPlane> judged = JudgeAll(planes);
  std::set<int> gone;
  auto next = judged.begin();
  for (std::size_t i = 0; i < end; ++i)
  {
    const bool isJudged = next != judged.end() && next->Number == i;
    const bool isValid = isJudged && next->Count == planes[i].Returns.size() &&
      std::none_of(
        next->Others.begin(), next->Others.end(), [&](int other) { return gone.count(other) > 0; });
    const WeakPlane* const known = isValid ? &*next : nullptr;
    next += isJudged ? 1 : 0;
    lms3dFusedPlane& plane = planes[i];
    if (!MayGo(plane) || (known && !known->IsShown))
    {
      continue;
    }
    const WeakPlane weak = known ? *known : Judge(planes, i, end);
    if (!weak.IsShown)
    {
      continue;
    }
    const std::vector<lms3dMappedReturn> returns = plane.Returns;
    plane.Clear();
    gone.insert(static_cast<int>(i));
    for (const lms3dMappedReturn& mapped : returns)
    {
      if (!planes.AddToPlanes(weak.Others, mapped))
      {
        planes.AddFacet(mapped);
      }
    }
  }
}
