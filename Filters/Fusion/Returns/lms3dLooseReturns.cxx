// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dLooseReturns.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
// As a share of the bound: how far the returns of a single triangle may be from the plane that it
// joins.
constexpr double JoinShare = 0.9;
// The cosine of the largest angle between a triangle and the plane that it joins.
constexpr double SmallestCosine = 0.9;
} // namespace

// Adds each return to the plane that is nearest to it.
void lms3dLooseReturns::AddToNearest(
  const std::vector<int>& returns, int ownPlane, std::vector<char>& isExplained)
{
  const std::vector<int> planes =
    this->Planes.FindPlanesNear(this->Local.Select(returns), this->Planes.GetSize());
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
    isExplained[i] = this->Planes.AddReturn(best, mapped) ? 1 : 0;
  }
}

// The plane that explains all returns of a triangle beside it.
int lms3dLooseReturns::FindPlaneBeside(const std::vector<int>& returns,
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
    if (plane.Verbatim.empty() && !plane.HasGone &&
      lms3dDot(plane.Frame.GetNormal(), normal) >= SmallestCosine &&
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

void lms3dLooseReturns::AddRest(const std::vector<char>& isExplained,
  const std::vector<int>& planeOfPatch, const lms3dSparseParts& sparse)
{
  std::map<int, std::vector<int>> restOf;
  for (std::size_t i = 0; i < this->Local.Returns.size(); ++i)
  {
    if (isExplained[i] == 0)
    {
      restOf[this->Local.Returns[i].Triangle].push_back(static_cast<int>(i));
    }
  }
  std::map<int, std::vector<int>> returnsOf;
  for (const auto& [triangle, rest] : restOf)
  {
    const std::vector<int> planes =
      this->Planes.FindPlanesNear(this->Local.Select(rest), this->Planes.GetSize());
    const int patch = this->Local.PatchIds[triangle];
    for (int i : rest)
    {
      if (this->Planes.AddToPlanes(planes, this->Local.Returns[i]))
      {
        continue;
      }
      if ((patch >= 0 && planeOfPatch[patch] >= 0) || sparse.IsSparseTriangle(triangle))
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
void lms3dLooseReturns::AddTriangle(int triangle, const std::vector<int>& returns)
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
  this->Planes.GrowBox(number, this->Local, triangle);
  this->Planes.GuessTriangle(number, this->Local, triangle);
  this->Planes.AcceptGuesses(number);
  for (int i : returns)
  {
    if (!this->Planes.AddReturn(number, this->Local.Returns[i]))
    {
      this->Planes.AddFacet(this->Local.Returns[i]);
    }
  }
}
