// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dScanJoin.h"

#include "Fusion/Passages/lms3dHiddenGuesses.h"
#include "Fusion/Planes/lms3dCreases.h"
#include "Fusion/Returns/lms3dLooseReturns.h"
#include "Fusion/Returns/lms3dSparseParts.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace
{
// As a share of the bound: how far the returns of a patch, apart from their noise, may be from a
// plane that the patch joins.
constexpr double MatchShare = 0.4;
constexpr double NoiseFactor = 4.0;
// A patch is curved if the root mean square of the distances of its returns exceeds this share of
// the bound, and if successive distances are correlated.
constexpr double CurvedShare = 0.05;
constexpr double SmallestCorrelation = 0.5;
// If other planes explain this share of a patch, it needs no plane of its own.
constexpr double ExplainedShare = 0.7;
// The share of a patch's returns that need not fit the plane.
constexpr double MisfitShare = 0.05;
// Returns farther from the plane of their patch may lie on another plane beside it: farther than
// this share of the bound, and than this multiple of the root mean square of the patch.
constexpr double LooseShare = 0.05;
constexpr double NearFactor = 2.0;
// The cosine of the largest angle between a patch and the plane that it joins.
constexpr double SmallestCosine = 0.9;
// A plane of a patch with fewer returns is weak.
constexpr std::size_t SmallestStrongCount = 3000;
// A patch with fewer returns may lie in a plane by chance.
constexpr std::size_t SmallestFlatCount = 20;

// Whether a patch shows a plane so well that a curved one must not explain it.
bool IsFlat(const std::vector<int>& returns, const lms3dFittedPlane& fit, double bound)
{
  return returns.size() >= SmallestFlatCount && fit.Deviation <= CurvedShare * bound;
}
} // namespace

void lms3dScanJoin::Join()
{
  const std::vector<std::vector<int>> returns = lms3dGetReturnsOfPatches(this->Local);
  std::vector<std::optional<lms3dFittedPlane>> fits(returns.size());
  tbb::parallel_for(std::size_t{ 0 }, returns.size(),
    [&](std::size_t patch)
    { fits[patch] = lms3dFitPlane(this->Local, returns[patch], this->Planes.GetMaximumError()); });
  const std::size_t planesBefore = this->Planes.GetSize();
  for (std::size_t i = 0; i < planesBefore; ++i)
  {
    this->AddIfJoinable(static_cast<int>(i));
  }
  std::vector<int> planeOfPatch(returns.size(), -1);
  PatchesOfPlanes patches;
  for (std::size_t patch = 0; patch < returns.size(); ++patch)
  {
    const std::optional<lms3dFittedPlane>& fit = fits[patch];
    const int plane = fit ? this->FindOrMakePlane(returns[patch], *fit, planesBefore) : -1;
    planeOfPatch[patch] = plane;
    if (fit && plane >= 0)
    {
      patches[plane].push_back({ static_cast<int>(patch), &returns[patch], fit->Deviation, {} });
    }
  }
  std::vector<char> isExplained(this->Local.Returns.size());
  this->AddReturns(patches, isExplained);
  const lms3dSparseParts sparse(this->Local, this->Planes.GetCell());
  const std::vector<int> dense = sparse.SelectDense(planeOfPatch);
  this->GuessTriangles(dense);
  sparse.Guess(returns, planeOfPatch, this->Ranges.GetTable(), this->Planes);
  lms3dTakeOutHiddenGuesses(this->Local, this->Ranges, dense, this->Planes);
  this->AcceptGuesses(planeOfPatch);
  this->AddLoose(patches, isExplained);
  lms3dAddCreases(this->Local, dense, this->Planes);
  lms3dLooseReturns(this->Local, this->Planes).AddRest(isExplained, planeOfPatch, sparse);
}

// Most planes of a large map are none that a patch may join.
void lms3dScanJoin::AddIfJoinable(int number)
{
  const lms3dFusedPlane& plane = this->Planes[number];
  if (plane.Verbatim.empty() && !plane.IsCurved && !plane.HasGone)
  {
    this->Joinable.push_back(number);
    this->Frames.push_back(plane.Frame);
  }
}

// Adds the returns that are near the planes of their patches. The threads divide planes.
void lms3dScanJoin::AddReturns(PatchesOfPlanes& patches, std::vector<char>& isExplained)
{
  tbb::parallel_for_each(patches,
    [&](PatchesOfPlanes::value_type& place)
    {
      const lms3dPlaneFrame& frame = this->Planes[place.first].Frame;
      for (PatchOfPlane& patch : place.second)
      {
        const double near =
          std::max(LooseShare * this->Planes.GetMaximumError(), NearFactor * patch.Deviation);
        for (const int i : *patch.Returns)
        {
          if (std::abs(frame.GetHeight(this->Local.Returns[i].Point)) > near)
          {
            patch.Loose.push_back(i);
            continue;
          }
          isExplained[i] = this->Planes.AddReturn(place.first, this->Local.Returns[i]) ? 1 : 0;
        }
      }
    });
}

// Adds the returns that are far from the planes of their patches, patch by patch.
void lms3dScanJoin::AddLoose(const PatchesOfPlanes& patches, std::vector<char>& isExplained)
{
  std::map<int, std::pair<int, const std::vector<int>*>> loose;
  for (const auto& [plane, patchesOfPlane] : patches)
  {
    for (const PatchOfPlane& patch : patchesOfPlane)
    {
      if (!patch.Loose.empty())
      {
        loose[patch.Number] = { plane, &patch.Loose };
      }
    }
  }
  lms3dLooseReturns rest(this->Local, this->Planes);
  for (const auto& [patch, place] : loose)
  {
    rest.AddToNearest(*place.second, place.first, isExplained);
  }
}

// Lets the planes have surface where their patches are. The threads divide planes.
void lms3dScanJoin::GuessTriangles(const std::vector<int>& planeOfPatch)
{
  std::map<int, std::vector<int>> triangles;
  for (std::size_t triangle = 0; triangle < this->Local.PatchIds.size(); ++triangle)
  {
    const int patch = this->Local.PatchIds[triangle];
    if (patch >= 0 && planeOfPatch[patch] >= 0)
    {
      const auto number = static_cast<int>(triangle);
      triangles[planeOfPatch[patch]].push_back(number);
      this->Planes.GrowBox(planeOfPatch[patch], this->Local, number);
    }
  }
  tbb::parallel_for_each(triangles,
    [this](const auto& place)
    {
      for (const int triangle : place.second)
      {
        this->Planes.GuessTriangle(place.first, this->Local, triangle);
      }
    });
}

void lms3dScanJoin::AcceptGuesses(const std::vector<int>& planeOfPatch)
{
  const std::set<int> planes(planeOfPatch.begin(), planeOfPatch.end());
  tbb::parallel_for_each(planes,
    [this](int plane)
    {
      if (plane >= 0)
      {
        this->Planes.AcceptGuesses(plane);
      }
    });
}

// Returns -1 if the patch needs no plane of its own, or is too curved for one.
int lms3dScanJoin::FindOrMakePlane(
  const std::vector<int>& returns, const lms3dFittedPlane& fit, std::size_t planesBefore)
{
  const int found = this->FindPlane(returns, fit);
  const double bound = this->Planes.GetMaximumError();
  if (found >= 0 || fit.Deviation > MatchShare * bound ||
    this->IsMostlyExplained(this->Local.Select(returns), planesBefore, IsFlat(returns, fit, bound)))
  {
    return found;
  }
  const int made = this->Planes.MakePlane(fit.Centre, fit.Normal);
  lms3dFusedPlane& plane = this->Planes[made];
  plane.IsCurved = fit.Correlation > SmallestCorrelation && fit.Deviation > CurvedShare * bound;
  plane.IsWeak = plane.IsCurved || returns.size() < SmallestStrongCount;
  this->AddIfJoinable(made);
  return made;
}

int lms3dScanJoin::FindPlane(const std::vector<int>& returns, const lms3dFittedPlane& fit) const
{
  const double bound = std::min(this->Planes.GetLargestDistance(),
    MatchShare * this->Planes.GetMaximumError() + NoiseFactor * fit.Deviation);
  int best = -1;
  double least = 0.0;
  for (std::size_t i = 0; i < this->Joinable.size(); ++i)
  {
    const lms3dPlaneFrame& frame = this->Frames[i];
    const double distance = std::abs(frame.GetHeight(fit.Centre));
    if (distance > bound || lms3dDot(frame.GetNormal(), fit.Normal) < SmallestCosine ||
      (best >= 0 && distance >= least))
    {
      continue;
    }
    const lms3dFusedPlane& plane = this->Planes[this->Joinable[i]];
    const auto misfits = std::count_if(returns.begin(), returns.end(),
      [&](int number)
      {
        const lms3dMappedReturn& mapped = this->Local.Returns[number];
        return !plane.Explains(mapped.Point, mapped.Direction, bound);
      });
    if (static_cast<double>(misfits) <= MisfitShare * static_cast<double>(returns.size()))
    {
      best = this->Joinable[i];
      least = distance;
    }
  }
  return best;
}

bool lms3dScanJoin::IsMostlyExplained(
  const std::vector<lms3dMappedReturn>& returns, std::size_t end, bool isFlat) const
{
  std::vector<int> planes = this->Planes.FindPlanesNear(returns, end);
  if (isFlat)
  {
    planes.erase(std::remove_if(planes.begin(), planes.end(),
                   [this](int plane) { return this->Planes[plane].IsCurved; }),
      planes.end());
  }
  return this->Planes.ShowShare(ExplainedShare, planes, returns);
}
