// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dMapSimplifier.h"

#include "LocalMap/Bounded/lms3dDeviationMeter.h"
#include "LocalMap/Bounded/lms3dEdgeCollapser.h"
#include "LocalMap/Bounded/lms3dRayMoves.h"
#include "LocalMap/Bounded/lms3dRegularMoves.h"
#include "LocalMap/Bounded/lms3dSmoothVertices.h"
#include "LocalMap/Bounded/lms3dVertexFit.h"
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace
{
// How often vertices are fitted to the returns, after which more edges can collapse.
constexpr int Fits = 2;
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
  const bool isSmoother = this->SimplifySmoothSurface(members, map, demands, stars);
  if (lms3dVertexRemover(lms3dRegularMoves(demands, shortcuts), stars).Run() || isSmoother)
  {
    Replace(stars, map);
    map.LargestDeviation = this->GetLargestDeviation(map);
    return true;
  }
  return false;
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

bool lms3dMapSimplifier::SimplifySmoothSurface(const std::vector<int>& members,
  const lms3dBoundedMap& map, const lms3dBeamDemands& demands, lms3dVertexStars& stars) const
{
  const lms3dSmoothVertices smooth(this->Patches, members, map, this->MaximumError, this->Noise);
  if (!FreeSmoothVertices(smooth, stars) || !lms3dEdgeCollapser::Run(demands, stars))
  {
    return false;
  }
  for (int fit = 0; fit < Fits; ++fit)
  {
    FitVertices(demands, stars);
    stars.ReleaseChanged();
    lms3dEdgeCollapser::Run(demands, stars);
  }
  FreeSmoothBorders(smooth, stars);
  FitVertices(demands, stars);
  return true;
}

// Returns false if there are none.
bool lms3dMapSimplifier::FreeSmoothVertices(
  const lms3dSmoothVertices& smooth, lms3dVertexStars& stars)
{
  std::vector<std::uint8_t> isFree(stars.GetNumberOfVertices());
  tbb::parallel_for(0, stars.GetNumberOfVertices(),
    [&](int i) { isFree[i] = stars.IsInside(i) && smooth.IsSmooth(stars, i); });
  if (std::find(isFree.begin(), isFree.end(), 1) == isFree.end())
  {
    return false;
  }
  stars.SetFree(isFree);
  return true;
}

// Vertices at the border of the surface lie on the planes of patches that are gone where edges have
// collapsed.
void lms3dMapSimplifier::FreeSmoothBorders(
  const lms3dSmoothVertices& smooth, lms3dVertexStars& stars)
{
  tbb::parallel_for(0, stars.GetNumberOfVertices(),
    [&](int i)
    {
      const lms3dVertexStars::Vertex& vertex = stars.GetVertex(i);
      if (vertex.IsChanged && !vertex.IsFree && !vertex.Triangles.empty() && !stars.HasStrip(i) &&
        !stars.IsInside(i) && smooth.IsSmooth(stars, i))
      {
        stars.SetFreeToFit(i);
      }
    });
}

// Each fit uses the ranges of the neighbours that come before it. So vertices of one level have no
// edge between them, and the neighbours that come before them have lower levels.
std::vector<std::vector<std::int32_t>> lms3dMapSimplifier::FindLevels(const lms3dVertexStars& stars)
{
  std::vector<std::vector<std::int32_t>> levels;
  std::vector<int> levelOf(stars.GetNumberOfVertices(), -1);
  for (std::int32_t number = 0; number < stars.GetNumberOfVertices(); ++number)
  {
    const lms3dVertexStars::Vertex& vertex = stars.GetVertex(number);
    if (!vertex.IsFree || !vertex.IsChanged)
    {
      continue;
    }
    int level = 0;
    stars.ForEachTriangle(number,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        level = std::max(level, 1 + std::max(levelOf[next], levelOf[last]));
        return true;
      });
    levelOf[number] = level;
    if (level == static_cast<int>(levels.size()))
    {
      levels.emplace_back();
    }
    levels[level].push_back(number);
  }
  return levels;
}

// Moves the vertices of changed stars to the ranges that fit the returns best.
void lms3dMapSimplifier::FitVertices(const lms3dBeamDemands& demands, lms3dVertexStars& stars)
{
  const auto fitVertex = [&](std::int32_t number)
  {
    const lms3dTriangleCorner& corner = stars.GetVertex(number).Corner;
    lms3dVertexFit fit(demands);
    if (stars.ForEachTriangle(number,
          [&](std::int32_t, std::int32_t next, std::int32_t last)
          { return fit.Add(corner, lms3dVertexFit::GetSide(stars, next, last)); }) &&
      fit.IsDetermined() && fit.GetInverse() > 0.0)
    {
      stars.SetInverse(number, fit.GetInverse());
    }
  };
  for (const std::vector<std::int32_t>& level : FindLevels(stars))
  {
    tbb::parallel_for(std::size_t(0), level.size(), [&](std::size_t i) { fitVertex(level[i]); });
  }
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
    if (stars.GetVertex(vertex).IsFree && stars.GetVertex(vertex).IsChanged)
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
  return lms3dDeviationMeter(this->Sphere, this->Patches, map)
    .GetLargest(
      { { lms3dDeviationMeter::AllPatches, 0, map.Triangles.size(), this->MaximumError } });
}
