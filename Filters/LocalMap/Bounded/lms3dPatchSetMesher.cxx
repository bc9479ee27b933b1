// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPatchSetMesher.h"

#include "LocalMap/Bounded/lms3dFailedPatches.h"
#include "LocalMap/Bounded/lms3dPatchSplitter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace
{
// The largest share of a patch's returns that may leave the patch before all of it is split.
constexpr double MaximumReleasedShare = 0.01;
} // namespace

bool lms3dPatchSetMesher::TryToMesh(
  lms3dPatches& patches, const std::vector<int>& members, bool releasesFew, lms3dBoundedMap& map)
{
  const lms3dBorderGates gates(
    this->Sphere, patches, lms3dPatches::CreaseShare * this->MaximumError);
  const lms3dPatchOutlines outlines(this->Sphere, patches, gates);
  Meshes meshes = this->MakeMeshes(patches, outlines, members);
  if (!this->Sphere.IsRegular())
  {
    if (this->SplitAtFaults(patches, outlines, members, releasesFew, meshes))
    {
      return false;
    }
    this->Append(outlines, meshes, members, map);
    return true;
  }
  std::vector<bool> failed(members.size());
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    failed[i] = members[i] > 0 && !meshes[i].IsValid;
    if (!releasesFew ||
      MaximumReleasedShare * members[i] < static_cast<double>(meshes[i].Uncovered.size()))
    {
      meshes[i].Uncovered.clear();
    }
  }
  for (std::int32_t patch : outlines.GetPatchesAtFlippedStrips())
  {
    failed[patch] = true;
    meshes[patch].Uncovered.clear();
  }
  if (std::find(failed.begin(), failed.end(), true) != failed.end())
  {
    lms3dBeamVector<std::int32_t> labels = patches.Labels;
    if (releasesFew)
    {
      lms3dDivideFailedPatches(this->Sphere, members, failed, meshes, patches);
    }
    else
    {
      this->Split(patches, members, failed, meshes);
    }
    this->Kept.Keep(std::move(labels), outlines, std::move(meshes));
    return false;
  }
  this->Append(outlines, meshes, members, map);
  return true;
}

// The returns that other patches represent, sorted by beam, nearest first.
std::vector<lms3dRayCheck::Hit> lms3dPatchSetMesher::CollectOthers(const Meshes& meshes)
{
  std::vector<lms3dRayCheck::Hit> others;
  for (const lms3dPatchMesh& mesh : meshes)
  {
    others.insert(others.end(), mesh.Rays.Others.begin(), mesh.Rays.Others.end());
  }
  std::sort(others.begin(), others.end());
  return others;
}

// For beams that are not regular. Returns false if there are no faults: each return is within the
// bound of its own patch or of another.
bool lms3dPatchSetMesher::SplitAtFaults(lms3dPatches& patches, const lms3dPatchOutlines& outlines,
  const std::vector<int>& members, bool isLenient, Meshes& meshes) const
{
  const std::vector<lms3dRayCheck::Hit> others = CollectOthers(meshes);
  lms3dPatchSplitter splitter(this->Sphere, patches, members);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const auto patch = static_cast<std::int32_t>(i);
    lms3dRayCheck& rays = meshes[i].Rays;
    if (members[i] > 0 && !meshes[i].IsValid)
    {
      isLenient ? splitter.Divide(patch) : splitter.Dissolve(patch);
    }
    for (GridIndex index : rays.Uncovered)
    {
      const auto other =
        std::lower_bound(others.begin(), others.end(), lms3dRayCheck::Hit{ index, 0.0 });
      if (other == others.end() || other->first != index)
      {
        splitter.Release(index);
      }
      else
      {
        rays.LargestDeviation = std::max(rays.LargestDeviation, other->second);
      }
    }
    for (GridIndex beam : rays.Blocked)
    {
      isLenient ? splitter.ReleaseAround(beam, patch) : splitter.Dissolve(patch);
    }
  }
  for (GridIndex index : outlines.GetReturnsAtFlippedStrips())
  {
    splitter.Release(index);
  }
  return splitter.Apply();
}

lms3dPatchSetMesher::Meshes lms3dPatchSetMesher::MakeMeshes(
  const lms3dPatches& patches, const lms3dPatchOutlines& outlines, const std::vector<int>& members)
{
  this->Kept.FindChanges(patches);
  lms3dPatchMesher mesher(this->Sphere, patches, outlines, this->MaximumError, this->Noise);
  Meshes meshes(members.size());
  tbb::parallel_for(std::size_t(0), members.size(),
    [&](std::size_t i)
    {
      const auto patch = static_cast<int>(i);
      if (members[i] > 0 && !this->Kept.TryToTake(patch, outlines, meshes[i]))
      {
        meshes[i] = mesher.Mesh(patch, members[i]);
      }
    });
  return meshes;
}

void lms3dPatchSetMesher::Append(const lms3dPatchOutlines& outlines, const Meshes& meshes,
  const std::vector<int>& members, lms3dBoundedMap& map)
{
  const auto addPoint = [&](const lms3dMapVertex& vertex)
  {
    map.Points.push_back({ vertex.Direction[0] / vertex.InverseRange,
      vertex.Direction[1] / vertex.InverseRange, vertex.Direction[2] / vertex.InverseRange });
  };
  std::for_each(outlines.GetVertices().begin(), outlines.GetVertices().end(), addPoint);
  const std::int32_t shared = static_cast<std::int32_t>(map.Points.size());
  map.Triangles = outlines.GetStripTriangles();
  map.PatchIds.assign(map.Triangles.size(), lms3dBoundedMap::NoPatch);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    if (members[i] == 0)
    {
      continue;
    }
    const std::int32_t offset = static_cast<std::int32_t>(map.Points.size()) - shared;
    std::for_each(meshes[i].Added.begin(), meshes[i].Added.end(), addPoint);
    for (std::array<std::int32_t, 3> triangle : meshes[i].Triangles)
    {
      for (std::int32_t& corner : triangle)
      {
        corner += corner >= shared ? offset : 0;
      }
      map.Triangles.push_back(triangle);
      map.PatchIds.push_back(map.NumberOfPatches);
    }
    ++map.NumberOfPatches;
    map.ReturnsOnPatches += members[i];
  }
  for (const lms3dPatchMesh& mesh : meshes)
  {
    map.LargestDeviation = std::max(map.LargestDeviation, mesh.Rays.LargestDeviation);
  }
}

void lms3dPatchSetMesher::Split(lms3dPatches& patches, const std::vector<int>& members,
  const std::vector<bool>& failed, const Meshes& meshes) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    const std::int32_t label = patches.Labels[index];
    if (label < 0 || label >= static_cast<std::int32_t>(failed.size()) || !failed[label])
    {
      continue;
    }
    const std::vector<GridIndex>& uncovered = meshes[label].Uncovered;
    const GridIndex first = this->Sphere.IsPoleCopy(index) ? this->Sphere.GetRow(index) : index;
    if (!uncovered.empty() && !std::binary_search(uncovered.begin(), uncovered.end(), first))
    {
      continue;
    }
    if (members[label] == 1 || this->Sphere.IsFilled(index))
    {
      patches.Labels[index] = lms3dPatches::None;
    }
    else if (first != index)
    {
      patches.Labels[index] = patches.Labels[first];
    }
    else
    {
      this->MakeSingle(patches, index);
    }
  }
}

// Moves a return to a new patch of its own.
void lms3dPatchSetMesher::MakeSingle(lms3dPatches& patches, GridIndex index) const
{
  lms3dPatches::Patch single;
  single.Fit.Add(this->Sphere, index);
  single.Plane = single.Fit.GetPlane();
  patches.Labels[index] = static_cast<std::int32_t>(patches.Patches.size());
  patches.Patches.push_back(single);
}
