// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dFailedPatches.h"

#include "LocalMap/Bounded/lms3dPatchSplitter.h"

#include <cstddef>

namespace
{
using GridIndex = lms3dBeamSphere::GridIndex;

// The largest number of returns of a patch that falls apart at once if it fails.
constexpr int MaximumScattered = 16;

// The largest patch of a neighbour on the same surface, or None.
std::int32_t FindPatchBeside(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, GridIndex index)
{
  std::int32_t best = lms3dPatches::None;
  double largest = 0.0;
  for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
  {
    const bool isJoined = sphere.HasNeighbor(index, side) && sphere.IsJoined(index, side);
    const std::int32_t label =
      isJoined ? patches.Labels[sphere.GetNeighbor(index, side)] : lms3dPatches::None;
    if (label >= 0 && patches.Patches[label].Fit.GetNumberOfReturns() > largest)
    {
      best = label;
      largest = patches.Patches[label].Fit.GetNumberOfReturns();
    }
  }
  return best;
}

// Moves returns that have just lost their patch to the patch of a neighbour, each once: a facet
// would leave a hole in the surface around it.
void MoveLostReturns(
  const lms3dBeamSphere& sphere, const lms3dBeamVector<std::int32_t>& before, lms3dPatches& patches)
{
  for (GridIndex index = 0; index < sphere.GetSize(); ++index)
  {
    if (before[index] < 0 || patches.Labels[index] >= 0 || sphere.IsFilled(index) ||
      sphere.IsPoleRow(sphere.GetRow(index)))
    {
      continue;
    }
    patches.HasMoved.resize(sphere.GetSize(), false);
    if (!patches.HasMoved[index])
    {
      patches.HasMoved[index] = true;
      patches.Labels[index] = FindPatchBeside(sphere, patches, index);
    }
  }
}
} // namespace

void lms3dDivideFailedPatches(const lms3dBeamSphere& sphere, const std::vector<int>& members,
  const std::vector<bool>& failed, const std::vector<lms3dPatchMesh>& meshes, lms3dPatches& patches)
{
  const lms3dBeamVector<std::int32_t> before = patches.Labels;
  lms3dPatchSplitter splitter(sphere, patches, members);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const auto patch = static_cast<std::int32_t>(i);
    for (GridIndex index : meshes[i].Uncovered)
    {
      splitter.Release(index);
    }
    if (failed[i] && meshes[i].Uncovered.empty())
    {
      members[i] <= MaximumScattered ? splitter.Scatter(patch) : splitter.Divide(patch);
    }
  }
  splitter.Apply();
  MoveLostReturns(sphere, before, patches);
}
