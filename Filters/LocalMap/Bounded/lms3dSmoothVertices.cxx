// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dSmoothVertices.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// The cosine of the largest angle between the planes of smoothly joined patches.
constexpr double SmoothCosine = 0.5;
// The noise, as a share of the bound, above which ranges are noisy.
constexpr double NoisyShare = 0.05;
// The smallest number of returns that makes a plane reliable.
constexpr int ReliableReturns = 12;
// The largest offset that noise can make, in bounds.
constexpr double OffsetInBounds = 1.5;
constexpr lms3dVector Unreliable = { 0.0, 0.0, 0.0 };
} // namespace

lms3dSmoothVertices::lms3dSmoothVertices(const lms3dPatches& patches,
  const std::vector<int>& members, const lms3dBoundedMap& map, const lms3dVertexStars& stars,
  double maximumError, double noise)
  : Map(map)
  , Stars(stars)
  , MaximumOffset(noise > NoisyShare * maximumError ? OffsetInBounds * maximumError : 0.0)
  , AreSmooth(stars.GetNumberOfVertices())
  , AreSmoothIfCurved(stars.GetNumberOfVertices())
{
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    if (members[i] > 0)
    {
      this->Normals.push_back(
        members[i] >= ReliableReturns ? lms3dNormalize(patches.Patches[i].Plane.Q) : Unreliable);
    }
  }
  tbb::parallel_for(0, stars.GetNumberOfVertices(), [this](int i) { this->Classify(i); });
  const auto count = std::count(this->AreSmoothIfCurved.begin(), this->AreSmoothIfCurved.end(), 1);
  this->IsSurfaceCurved = 2 * count >= stars.GetNumberOfVertices();
}

// Compares the ranges at the ends of the shortest edge, as the sensor sees it. It leads across the
// offset.
bool lms3dSmoothVertices::IsSmallOffset(std::int32_t triangle) const
{
  const std::array<std::int32_t, 3>& corners = this->Stars.GetTriangles()[triangle].Corners;
  double largestCosine = -1.0;
  double offset = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const lms3dVertexStars::Vertex& a = this->Stars.GetVertex(corners[i]);
    const lms3dVertexStars::Vertex& b = this->Stars.GetVertex(corners[(i + 1) % 3]);
    const double cosine = lms3dDot(a.Corner.Position, b.Corner.Position);
    if (cosine > largestCosine)
    {
      largestCosine = cosine;
      offset = std::abs(1.0 / a.Inverse - 1.0 / b.Inverse);
    }
  }
  return offset <= this->MaximumOffset;
}

void lms3dSmoothVertices::AppendPatches(
  std::int32_t vertex, std::vector<std::int32_t>& patches) const
{
  for (std::int32_t triangle : this->Stars.GetVertex(vertex).Triangles)
  {
    if (this->Map.PatchIds[triangle] != lms3dBoundedMap::NoPatch)
    {
      patches.push_back(this->Map.PatchIds[triangle]);
    }
  }
}

// Appends the patches on the other sides of offsets. Returns whether all offsets are small.
bool lms3dSmoothVertices::AppendPatchesBeyondOffsets(
  std::int32_t vertex, std::vector<std::int32_t>& patches) const
{
  bool areSmall = true;
  for (std::int32_t triangle : this->Stars.GetVertex(vertex).Triangles)
  {
    if (this->Map.PatchIds[triangle] == lms3dBoundedMap::NoPatch)
    {
      areSmall = areSmall && this->IsSmallOffset(triangle);
      for (std::int32_t corner : this->Stars.GetTriangles()[triangle].Corners)
      {
        this->AppendPatches(corner, patches);
      }
    }
  }
  return areSmall;
}

// Returns the patch that all triangles at a vertex have in common, or NoPatch.
std::int32_t lms3dSmoothVertices::GetOnlyPatch(std::int32_t vertex) const
{
  const std::vector<std::int32_t>& triangles = this->Stars.GetVertex(vertex).Triangles;
  const std::int32_t patch = this->Map.PatchIds[triangles.front()];
  const bool isOnly = std::all_of(triangles.begin(), triangles.end(),
    [&](std::int32_t triangle) { return this->Map.PatchIds[triangle] == patch; });
  return isOnly ? patch : lms3dBoundedMap::NoPatch;
}

void lms3dSmoothVertices::Classify(std::int32_t vertex)
{
  if (!this->Stars.IsInside(vertex))
  {
    return;
  }
  // Most vertices have one patch, for which no list is needed.
  const std::int32_t only = this->GetOnlyPatch(vertex);
  if (only != lms3dBoundedMap::NoPatch)
  {
    this->AreSmoothIfCurved[vertex] = 1;
    this->AreSmooth[vertex] = this->Normals[only] != Unreliable || this->IsNoisy() ? 1 : 0;
    return;
  }
  std::vector<std::int32_t> patches;
  this->AppendPatches(vertex, patches);
  const bool areOffsetsSmall = this->AppendPatchesBeyondOffsets(vertex, patches);
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  const auto reliable = std::partition(patches.begin(), patches.end(),
    [this](std::int32_t patch) { return this->Normals[patch] == Unreliable; });
  const bool areSimilar = std::all_of(reliable, patches.end(),
    [&](std::int32_t a)
    {
      return std::all_of(reliable, patches.end(),
        [&](std::int32_t b)
        { return lms3dDot(this->Normals[a], this->Normals[b]) >= SmoothCosine; });
    });
  const bool areReliable = reliable == patches.begin();
  this->AreSmoothIfCurved[vertex] = areSimilar ? 1 : 0;
  this->AreSmooth[vertex] =
    areSimilar && areOffsetsSmall && (areReliable || this->IsNoisy()) ? 1 : 0;
}
