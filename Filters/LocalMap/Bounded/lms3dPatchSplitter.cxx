// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPatchSplitter.h"

#include <algorithm>
#include <limits>

namespace
{
// How far from a beam ReleaseAround() searches, in entries of the grid.
constexpr int MaximumRadius = 3;
} // namespace

lms3dPatchSplitter::lms3dPatchSplitter(
  const lms3dBeamSphere& sphere, lms3dPatches& patches, const std::vector<int>& members)
  : Sphere(sphere)
  , Patches(patches)
  , Members(members)
  , IsReleased(sphere.GetSize(), false)
  , IsDivided(members.size(), false)
  , IsScattered(members.size(), false)
  , IsDissolved(members.size(), false)
  , IsAffected(members.size(), 0)
{
}

void lms3dPatchSplitter::SetAffected(std::int32_t patch)
{
  if (patch >= 0)
  {
    this->IsAffected[patch] = 1;
  }
}

void lms3dPatchSplitter::Divide(std::int32_t patch)
{
  this->IsDivided[patch] = true;
  this->SetAffected(patch);
}

void lms3dPatchSplitter::Scatter(std::int32_t patch)
{
  this->IsScattered[patch] = true;
  this->SetAffected(patch);
}

void lms3dPatchSplitter::Dissolve(std::int32_t patch)
{
  this->IsDissolved[patch] = true;
  this->SetAffected(patch);
}

void lms3dPatchSplitter::Release(GridIndex index)
{
  this->IsReleased[this->Sphere.IsPoleCopy(index) ? this->Sphere.GetRow(index) : index] = true;
  this->SetAffected(this->Patches.Labels[index]);
}

void lms3dPatchSplitter::ReleaseAround(GridIndex beam, std::int32_t patch)
{
  for (int radius = 1; radius <= MaximumRadius; ++radius)
  {
    if (this->ReleaseRing(beam, patch, radius))
    {
      return;
    }
  }
  this->Divide(patch);
}

// Releases the returns of a patch in a square around a beam. Returns false if there are none.
bool lms3dPatchSplitter::ReleaseRing(GridIndex beam, std::int32_t patch, int radius)
{
  const int columns = this->Sphere.GetNumberOfColumns();
  const int row = this->Sphere.GetRow(beam);
  const int lowest = std::max(0, row - radius);
  const int highest = std::min(this->Sphere.GetNumberOfRows() - 1, row + radius);
  bool isFound = false;
  for (int side = -radius; side <= radius; ++side)
  {
    const int column = (this->Sphere.GetColumn(beam) + side + columns) % columns;
    for (int other = lowest; other <= highest; ++other)
    {
      const GridIndex index = this->Sphere.GetIndex(column, other);
      if (this->Patches.Labels[index] == patch)
      {
        this->Release(index);
        isFound = true;
      }
    }
  }
  return isFound;
}

bool lms3dPatchSplitter::Apply()
{
  this->FindExtents();
  bool isChanged = false;
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    const std::int32_t label = this->Patches.Labels[index];
    if (label >= 0 && this->IsAffected[label] != 0)
    {
      // All entries of a pole follow the first.
      this->Patches.Labels[index] = this->Sphere.IsPoleCopy(index)
        ? this->Patches.Labels[this->Sphere.GetRow(index)]
        : this->GetNewLabel(index, label);
      isChanged |= this->Patches.Labels[index] != label;
    }
  }
  return isChanged;
}

void lms3dPatchSplitter::FindExtents()
{
  constexpr int Most = std::numeric_limits<int>::max();
  this->Extents.assign(this->Members.size(),
    { { Most, Most }, { -1, -1 }, 1,
      { lms3dPatches::None, lms3dPatches::None, lms3dPatches::None, lms3dPatches::None } });
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    const std::int32_t label = this->Patches.Labels[index];
    if (label < 0 || !this->IsDivided[label] || this->Sphere.IsPoleCopy(index))
    {
      continue;
    }
    Extent& extent = this->Extents[label];
    const std::array<int, 2> place = { this->Sphere.GetColumn(index), this->Sphere.GetRow(index) };
    for (int axis = 0; axis < 2; ++axis)
    {
      extent.First[axis] = std::min(extent.First[axis], place[axis]);
      extent.Last[axis] = std::max(extent.Last[axis], place[axis]);
      extent.Size = std::max(extent.Size, (extent.Last[axis] - extent.First[axis] + 2) / 2);
    }
  }
}

std::int32_t lms3dPatchSplitter::GetNewLabel(GridIndex index, std::int32_t label)
{
  const bool isReleased = this->IsReleased[index] || this->IsScattered[label];
  const bool isAffected = isReleased || this->IsDivided[label];
  const bool isLost =
    this->Sphere.IsFilled(index) ? isReleased : isAffected && this->Members[label] == 1;
  if (this->IsDissolved[label] || isLost)
  {
    return lms3dPatches::None;
  }
  if (isReleased)
  {
    return this->AddPatch(nullptr, index);
  }
  return this->IsDivided[label] ? this->GetPart(index, label) : label;
}

// The patch of a part keeps the plane of the whole.
std::int32_t lms3dPatchSplitter::GetPart(GridIndex index, std::int32_t label)
{
  Extent& extent = this->Extents[label];
  const bool isRight = this->Sphere.GetColumn(index) - extent.First[0] >= extent.Size;
  const bool isUpper = this->Sphere.GetRow(index) - extent.First[1] >= extent.Size;
  std::int32_t& part = extent.Parts[(isRight ? 1 : 0) + (isUpper ? 2 : 0)];
  if (part == lms3dPatches::None)
  {
    const lms3dPlane plane = this->Patches.Patches[label].Plane;
    part = this->AddPatch(&plane, index);
  }
  else
  {
    this->Patches.Patches[part].Fit.Add(this->Sphere, index);
  }
  return part;
}

// Adds a patch of one return. Without a plane, it faces the origin.
std::int32_t lms3dPatchSplitter::AddPatch(const lms3dPlane* plane, GridIndex index)
{
  lms3dPatches::Patch patch;
  patch.Fit.Add(this->Sphere, index);
  patch.Plane = plane ? *plane : patch.Fit.GetPlane();
  this->Patches.Patches.push_back(patch);
  return static_cast<std::int32_t>(this->Patches.Patches.size()) - 1;
}
