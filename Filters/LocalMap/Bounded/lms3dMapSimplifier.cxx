// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dMapSimplifier.h"

#include "LocalMap/Bounded/lms3dDeviationMeter.h"
#include "LocalMap/Bounded/lms3dEdgeCollapser.h"
#include "LocalMap/Bounded/lms3dEdgeFlipper.h"
#include "LocalMap/Bounded/lms3dRayMoves.h"
#include "LocalMap/Bounded/lms3dRegularMoves.h"
#include "LocalMap/Bounded/lms3dSmoothVertices.h"
#include "LocalMap/Bounded/lms3dSurfaceFit.h"
#include "LocalMap/Bounded/lms3dVertexFits.h"
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace
{
template <typename ConditionT>
std::vector<std::uint8_t> Choose(const lms3dVertexStars& stars, const ConditionT& isChosen)
{
  std::vector<std::uint8_t> chosen(stars.GetNumberOfVertices());
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    chosen[vertex] = isChosen(stars.GetVertex(vertex)) ? 1 : 0;
  }
  return chosen;
}
} // namespace

lms3dMapSimplifier::lms3dMapSimplifier(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , MaximumError(maximumError)
  , Noise(noise)
{
}

bool lms3dMapSimplifier::Simplify(const std::vector<int>& members, lms3dBoundedMap& map) const
{
  if (!this->Sphere.IsRegular())
  {
    return this->SimplifyOnRays(map);
  }
  lms3dVertexStars stars(map);
  const lms3dBeamDemands demands(this->Sphere, this->Patches, this->MaximumError);
  const lms3dBorderShortcuts shortcuts(
    this->Sphere, this->Patches, lms3dPatches::CreaseShare * this->MaximumError);
  const lms3dSmoothVertices smooth(
    this->Patches, members, map, stars, this->MaximumError, this->Noise);
  this->SimplifySmoothSurface(smooth, demands, shortcuts, stars);
  const lms3dRegularMoves moves(demands, shortcuts);
  lms3dVertexRemover(moves, stars).Run();
  this->FitSurface(demands, shortcuts, map.PatchIds, stars);
  // Fits and flips of a curved surface let more vertices go.
  if (smooth.IsCurved())
  {
    lms3dVertexRemover(moves, stars).Run();
    this->FitSurface(demands, shortcuts, map.PatchIds, stars);
  }
  Replace(stars, map);
  map.LargestDeviation = this->GetLargestDeviation(map);
  return true;
}

// The fit shows which diagonals of quadrilaterals are right.
void lms3dMapSimplifier::FitSurface(const lms3dBeamDemands& demands,
  const lms3dBorderShortcuts& borders, const std::vector<std::int32_t>& patchIds,
  lms3dVertexStars& stars) const
{
  std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
  lms3dSurfaceFit(demands, borders, this->MaximumError, isChosen, stars).Run();
  isChosen = lms3dEdgeFlipper(demands, patchIds, this->MaximumError, stars).Run();
  if (!isChosen.empty())
  {
    lms3dSurfaceFit(demands, borders, this->MaximumError, isChosen, stars).Run();
  }
}

bool lms3dMapSimplifier::SimplifyOnRays(lms3dBoundedMap& map) const
{
  lms3dVertexStars stars(map);
  const lms3dRayMoves moves(this->Sphere, this->MaximumError);
  if (lms3dVertexRemover(moves, stars).Run())
  {
    Replace(stars, map);
    map.LargestDeviation = moves.GetLargestDeviation(map);
    return true;
  }
  return false;
}

void lms3dMapSimplifier::SimplifySmoothSurface(const lms3dSmoothVertices& smooth,
  const lms3dBeamDemands& demands, const lms3dBorderShortcuts& borders,
  lms3dVertexStars& stars) const
{
  const std::vector<std::uint8_t>& areSmooth = smooth.Get();
  if (std::find(areSmooth.begin(), areSmooth.end(), 1) == areSmooth.end())
  {
    return;
  }
  stars.SetFree(areSmooth);
  if (!lms3dEdgeCollapser::Run(demands, smooth.IsCurved(), stars))
  {
    return;
  }
  // Afterwards more edges can collapse.
  const auto isFreeAndChanged = [](const auto& vertex)
  { return vertex.IsFree && vertex.IsChanged; };
  lms3dVertexFits::Run(demands, Choose(stars, isFreeAndChanged), stars);
  stars.ReleaseChanged();
  lms3dEdgeCollapser::Run(demands, smooth.IsCurved(), stars);
  const auto isChanged = [](const auto& vertex) { return vertex.IsChanged; };
  lms3dSurfaceFit(demands, borders, this->MaximumError, Choose(stars, isChanged), stars).Run();
}

void lms3dMapSimplifier::Replace(const lms3dVertexStars& stars, lms3dBoundedMap& map)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < map.Triangles.size(); ++i)
  {
    if (!stars.GetTriangles()[i].IsRemoved)
    {
      map.Triangles[kept] = stars.GetTriangles()[i].Corners;
      map.PatchIds[kept++] = map.PatchIds[i];
    }
  }
  map.Triangles.resize(kept);
  map.PatchIds.resize(kept);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    if (stars.GetVertex(vertex).HasMoved)
    {
      map.Points[vertex] = stars.GetPosition(vertex);
    }
  }
  map.RemoveUnusedPoints();
  map.RemoveUnusedPatches();
}

// A beam can hit a triangle of the patch beside its own.
double lms3dMapSimplifier::GetLargestDeviation(const lms3dBoundedMap& map) const
{
  return lms3dDeviationMeter(this->Sphere, this->Patches, map).GetLargest(this->MaximumError);
}
