// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dScanJoin.h"

#include "Fusion/lms3dCreases.h"
#include "Fusion/lms3dHiddenGuesses.h"
#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
// As a share of the bound: how far the returns of a patch, apart from their noise, may be from a plane that the patch joins.
constexpr double MatchShare = 0.4;
constexpr double NoiseFactor = 4.0;
// A patch is curved if the root mean square of the distances of its returns exceeds this share of the bound, and if
// successive distances are correlated.
constexpr double CurvedShare = 0.05;
constexpr double SmallestCorrelation = 0.5;
// If other planes explain this share of a patch, it needs no plane of its own.
constexpr double ExplainedShare = 0.7;
// The share of a patch's returns that need not fit the plane.
constexpr double MisfitShare = 0.05;
// As a share of the bound: how far the returns of a single triangle may be from the plane that it joins.
constexpr double JoinShare = 0.9;
// As a share of the bound: returns farther from the plane of their patch may lie on another plane beside it.
constexpr double LooseShare = 0.2;
// The cosine of the largest angle between a patch and the plane that it joins.
constexpr double SmallestCosine = 0.9;
// A plane of a patch with fewer returns is weak.
constexpr std::size_t SmallestStrongCount = 3000;

std::vector<lms3dMappedReturn> Select(const lms3dLocalMap& local, const std::vector<int>& numbers)
{
  std::vector<lms3dMappedReturn> returns;
  returns.reserve(numbers.size());
  for (int i : numbers)
  {
    returns.push_back(local.Returns[i]);
  }
  return returns;
}

} // namespace

void lms3dScanJoin::Join()
{
  std::vector<int> planeOfPatch(static_cast<std::size_t>(this->Local.NumberOfPatches), -1);
  std::vector<bool> isExplained(this->Local.Returns.size());
  const std::vector<std::vector<int>> returns = lms3dGetReturnsOfPatches(this->Local);
  const std::size_t planesBefore = this->Planes.GetSize();
  std::map<int, std::vector<int>> loose;
  for (int patch = 0; patch < this->Local.NumberOfPatches; ++patch)
  {
    const auto fit = lms3dFitPlane(this->Local, returns[patch], this->Planes.GetMaximumError());
    if (!fit)
    {
      continue;
    }
    planeOfPatch[patch] = this->FindOrMakePlane(returns[patch], *fit, planesBefore);
    if (planeOfPatch[patch] < 0)
    {
      continue;
    }
    const lms3dPlaneFrame& frame = this->Planes[planeOfPatch[patch]].Frame;
    const double near =
      std::max(LooseShare * this->Planes.GetMaximumError(), NoiseFactor * fit->Deviation);
    for (int i : returns[patch])
    {
      if (std::abs(frame.GetHeight(this->Local.Returns[i].Point)) > near)
      {
        loose[patch].push_back(i);
        continue;
      }
      isExplained[i] = this->Planes.AddReturn(planeOfPatch[patch], this->Local.Returns[i]);
    }
  }
  this->AddTriangles(planeOfPatch);
  for (const auto& [patch, numbers] : loose)
  {
    this->AddLoose(numbers, planeOfPatch[patch], isExplained);
  }
  lms3dAddCreases(this->Local, planeOfPatch, this->Planes);
  this->AddRest(isExplained, planeOfPatch);
}

// Lets the planes have surface where their patches are.
void lms3dScanJoin::AddTriangles(const std::vector<int>& planeOfPatch)
{
  for (std::size_t triangle = 0; triangle < this->Local.PatchIds.size(); ++triangle)
  {
    const int patch = this->Local.PatchIds[triangle];
    if (patch >= 0 && planeOfPatch[patch] >= 0)
    {
      this->Planes.AddTriangle(planeOfPatch[patch], this->Local, static_cast<int>(triangle));
    }
  }
  lms3dTakeOutHiddenGuesses(this->Local, this->Ranges, planeOfPatch, this->Planes);
  for (const int plane : std::set<int>(planeOfPatch.begin(), planeOfPatch.end()))
  {
    if (plane >= 0)
    {
      this->Planes.AcceptGuesses(plane);
    }
  }
}

// Returns -1 if the patch needs no plane of its own, or is too curved for one.
int lms3dScanJoin::FindOrMakePlane(
  const std::vector<int>& returns, const lms3dFittedPlane& fit, std::size_t planesBefore)
{
  const int found = this->FindPlane(returns, fit);
  const double bound = this->Planes.GetMaximumError();
  if (found >= 0 || fit.Deviation > MatchShare * bound ||
    this->IsMostlyExplained(Select(this->Local, returns), planesBefore))
  {
    return found;
  }
  const int made = this->Planes.MakePlane(fit.Centre, fit.Normal);
  lms3dFusedPlane& plane = this->Planes[made];
  plane.IsCurved = fit.Correlation > SmallestCorrelation && fit.Deviation > CurvedShare * bound;
  plane.IsWeak = plane.IsCurved || returns.size() < SmallestStrongCount;
  return made;
}

int lms3dScanJoin::FindPlane(const std::vector<int>& returns, const lms3dFittedPlane& fit) const
{
  const double bound = std::min(this->Planes.GetLargestDistance(),
    MatchShare * this->Planes.GetMaximumError() + NoiseFactor * fit.Deviation);
  int best = -1;
  double least = 0.0;
  for (std::size_t i = 0; i < this->Planes.GetSize(); ++i)
  {
    const lms3dFusedPlane& plane = this->Planes[i];
    const double distance = std::abs(plane.Frame.GetHeight(fit.Centre));
    if (!plane.Verbatim.empty() || plane.IsCurved || distance > bound ||
      lms3dDot(plane.Frame.GetNormal(), fit.Normal) < SmallestCosine ||
      (best >= 0 && distance >= least))
    {
      continue;
    }
    const auto misfits = std::count_if(returns.begin(), returns.end(),
      [&](int number)
      {
        const lms3dMappedReturn& mapped = this->Local.Returns[number];
        return !plane.Explains(mapped.Point, mapped.Direction, bound);
      });
    if (static_cast<double>(misfits) <= MisfitShare * static_cast<double>(returns.size()))
    {
      best = static_cast<int>(i);
      least = distance;
    }
  }
  return best;
}

bool lms3dScanJoin::IsMostlyExplained(
  const std::vector<lms3dMappedReturn>& returns, std::size_t end) const
{
  return this->Planes.ShowShare(ExplainedShare, this->Planes.FindPlanesNear(returns, end), returns);
}

// Adds each return to the plane that is nearest to it.
void lms3dScanJoin::AddLoose(
  const std::vector<int>& returns, int ownPlane, std::vector<bool>& isExplained)
{
  const std::vector<int> planes =
    this->Planes.FindPlanesNear(Select(this->Local, returns), this->Planes.GetSize());
  for (int i : returns)
  {
    const lms3dMappedReturn& mapped = this->Local.Returns[i];
    int best = ownPlane;
    double least = std::abs(this->Planes[ownPlane].Frame.GetHeight(mapped.Point));
    for (int plane : planes)
    {
      const double distance = std::abs(this->Planes[plane].Frame.GetHeight(mapped.Point));
      if (distance < least && this->Planes.Shows(this->Planes[plane], mapped))
      {
        best = plane;
        least = distance;
      }
    }
    isExplained[i] = this->Planes.AddReturn(best, mapped);
  }
}

// The plane that explains all returns of a triangle beside it.
int lms3dScanJoin::FindPlaneBeside(const std::vector<int>& returns,
  const std::array<lms3dVector, 3>& corners, const lms3dVector& normal) const
{
  const double bound = JoinShare * this->Planes.GetMaximumError();
  lms3dWorldBox box;
  for (const lms3dVector& corner : corners)
  {
    box.Add(corner);
  }
  for (const int i : this->Planes.FindPlanesNear(box, bound))
  {
    const lms3dFusedPlane& plane = this->Planes[i];
    if (plane.Verbatim.empty() && lms3dDot(plane.Frame.GetNormal(), normal) >= SmallestCosine &&
      std::all_of(returns.begin(), returns.end(),
        [&](int number)
        {
          const lms3dMappedReturn& mapped = this->Local.Returns[number];
          return plane.Explains(mapped.Point, mapped.Direction, bound);
        }))
    {
      return i;
    }
  }
  return -1;
}

void lms3dScanJoin::AddRest(
  const std::vector<bool>& isExplained, const std::vector<int>& planeOfPatch)
{
  std::map<int, std::vector<int>> restOf;
  for (std::size_t i = 0; i < this->Local.Returns.size(); ++i)
  {
    if (!isExplained[i])
    {
      restOf[this->Local.Returns[i].Triangle].push_back(static_cast<int>(i));
    }
  }
  std::map<int, std::vector<int>> returnsOf;
  for (const auto& [triangle, rest] : restOf)
  {
    const std::vector<int> planes =
      this->Planes.FindPlanesNear(Select(this->Local, rest), this->Planes.GetSize());
    const int patch = this->Local.PatchIds[triangle];
    for (int i : rest)
    {
      if (this->Planes.AddToPlanes(planes, this->Local.Returns[i]))
      {
        continue;
      }
      if (patch >= 0 && planeOfPatch[patch] >= 0)
      {
        this->Planes.AddFacet(this->Local.Returns[i]);
        continue;
      }
      returnsOf[triangle].push_back(i);
    }
  }
  for (const auto& [triangle, returns] : returnsOf)
  {
    this->AddTriangle(triangle, returns);
  }
}

// Adds a triangle of the local map to a plane beside it, or as a region of its own.
void lms3dScanJoin::AddTriangle(int triangle, const std::vector<int>& returns)
{
  const std::array<lms3dVector, 3> corners = { this->Local.GetCorner(triangle, 0),
    this->Local.GetCorner(triangle, 1), this->Local.GetCorner(triangle, 2) };
  const lms3dVector normal = lms3dNormalize(
    lms3dGetWeightedNormal({ corners[0].data(), corners[1].data(), corners[2].data() }));
  int number = this->FindPlaneBeside(returns, corners, normal);
  if (number < 0)
  {
    number = this->Planes.MakePlane(corners[0], normal);
    this->Planes[number].Verbatim.push_back(corners);
    this->Planes[number].IsCurved = true;
    this->Planes[number].IsWeak = true;
  }
  this->Planes.AddTriangle(number, this->Local, triangle);
  this->Planes.AcceptGuesses(number);
  for (int i : returns)
  {
    if (!this->Planes.AddReturn(number, this->Local.Returns[i]))
    {
      this->Planes.AddFacet(this->Local.Returns[i]);
    }
  }
}
