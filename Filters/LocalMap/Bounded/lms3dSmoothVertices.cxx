// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dSmoothVertices.h"

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
} // namespace

lms3dSmoothVertices::lms3dSmoothVertices(const lms3dPatches& patches,
  const std::vector<int>& members, const lms3dBoundedMap& map, double maximumError, double noise)
  : Map(map)
  , MaximumOffset(noise > NoisyShare * maximumError ? OffsetInBounds * maximumError : 0.0)
{
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    if (members[i] > 0)
    {
      this->Normals.push_back(members[i] >= ReliableReturns
          ? lms3dNormalize(patches.Patches[i].Plane.Q)
          : lms3dVector{ 0.0, 0.0, 0.0 });
    }
  }
}

// Compares the ranges at the ends of the shortest edge, as the sensor sees it. It leads across the
// offset.
bool lms3dSmoothVertices::IsSmallOffset(const lms3dVertexStars& stars, std::int32_t triangle) const
{
  const std::array<std::int32_t, 3>& corners = stars.GetTriangles()[triangle].Corners;
  double largestCosine = -1.0;
  double offset = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const lms3dVertexStars::Vertex& a = stars.GetVertex(corners[i]);
    const lms3dVertexStars::Vertex& b = stars.GetVertex(corners[(i + 1) % 3]);
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
  const lms3dVertexStars& stars, std::int32_t vertex, std::vector<std::int32_t>& patches) const
{
  for (std::int32_t triangle : stars.GetVertex(vertex).Triangles)
  {
    if (this->Map.PatchIds[triangle] != lms3dBoundedMap::NoPatch)
    {
      patches.push_back(this->Map.PatchIds[triangle]);
    }
  }
}

bool lms3dSmoothVertices::AreSmooth(std::int32_t a, std::int32_t b) const
{
  const lms3dVector zero = { 0.0, 0.0, 0.0 };
  return this->Normals[a] == zero || this->Normals[b] == zero
    ? this->IsNoisy()
    : lms3dDot(this->Normals[a], this->Normals[b]) >= SmoothCosine;
}

bool lms3dSmoothVertices::HasOnePatch(const lms3dVertexStars& stars, std::int32_t vertex) const
{
  const std::vector<std::int32_t>& triangles = stars.GetVertex(vertex).Triangles;
  return !triangles.empty() && this->Map.PatchIds[triangles.front()] != lms3dBoundedMap::NoPatch &&
    std::all_of(triangles.begin(), triangles.end(),
      [&](std::int32_t triangle)
      { return this->Map.PatchIds[triangle] == this->Map.PatchIds[triangles.front()]; });
}

// Compares the patches at a vertex with the first of them.
bool lms3dSmoothVertices::MayBeSmooth(const lms3dVertexStars& stars, std::int32_t vertex) const
{
  const std::vector<std::int32_t>& triangles = stars.GetVertex(vertex).Triangles;
  std::int32_t first = lms3dBoundedMap::NoPatch;
  return std::all_of(triangles.begin(), triangles.end(),
    [&](std::int32_t triangle)
    {
      const std::int32_t patch = this->Map.PatchIds[triangle];
      first = first == lms3dBoundedMap::NoPatch ? patch : first;
      return patch == lms3dBoundedMap::NoPatch || this->AreSmooth(first, patch);
    });
}

// The first two conditions decide for most vertices, without a list.
bool lms3dSmoothVertices::IsSmooth(const lms3dVertexStars& stars, std::int32_t vertex) const
{
  if (this->HasOnePatch(stars, vertex))
  {
    const std::int32_t patch = this->Map.PatchIds[stars.GetVertex(vertex).Triangles.front()];
    return this->AreSmooth(patch, patch);
  }
  if (!this->MayBeSmooth(stars, vertex))
  {
    return false;
  }
  std::vector<std::int32_t> patches;
  this->AppendPatches(stars, vertex, patches);
  for (std::int32_t triangle : stars.GetVertex(vertex).Triangles)
  {
    if (this->Map.PatchIds[triangle] != lms3dBoundedMap::NoPatch)
    {
      continue;
    }
    if (!this->IsSmallOffset(stars, triangle))
    {
      return false;
    }
    for (std::int32_t corner : stars.GetTriangles()[triangle].Corners)
    {
      this->AppendPatches(stars, corner, patches);
    }
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  return std::all_of(patches.begin(), patches.end(),
    [&](std::int32_t a)
    {
      return std::all_of(
        patches.begin(), patches.end(), [&](std::int32_t b) { return this->AreSmooth(a, b); });
    });
}
