// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include "LocalMap/Bounded/lms3dPatchMesherWork.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// How far a new vertex may lie off its return: as far as noise reaches, and within the bound with
// some room for the returns beside it.
constexpr double LiftInDeviations = 4.0;
constexpr double LiftInBounds = 0.8;
// The number of rounds in which each triangle gets one new vertex. Afterwards all beams beyond the
// bound become vertices.
constexpr int WorstOnlyRounds = 12;

} // namespace

lms3dPatchMesher::lms3dPatchMesher(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
  const lms3dPatchOutlines& outlines, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , Outlines(outlines)
  , MaximumError(maximumError)
  , MaximumLift(std::min(LiftInBounds * maximumError, LiftInDeviations * noise))
  , States(sphere.GetSize(), IsUncovered)
{
}

lms3dPatchMesh lms3dPatchMesher::Mesh(int patch, int members)
{
  lms3dPatchMesh mesh;
  Work work(this->Outlines, patch, members, this->Patches.Patches[patch].Plane);
  if (work.Triangulation.IsValid() && this->Refine(work))
  {
    mesh.IsValid = true;
    mesh.Added = work.Triangulation.GetAddedVertices();
    mesh.Triangles = work.Triangulation.GetTriangles();
    if (!this->Sphere.IsRegular())
    {
      mesh.Rays = lms3dCheckRays(
        this->Sphere, this->Patches, patch, members, work.Triangulation, this->MaximumError);
    }
  }
  else if (work.CoversOwnBeamsOnly)
  {
    mesh.Uncovered = this->FindUncovered(patch);
  }
  return mesh;
}

bool lms3dPatchMesher::Refine(Work& work)
{
  for (int round = 0;; ++round)
  {
    work.KeepsWorstOnly = round < WorstOnlyRounds;
    const bool isCovered = this->Check(work);
    if (!isCovered || work.Violations.empty())
    {
      return isCovered;
    }
    if (!this->InsertBeams(work))
    {
      return false;
    }
  }
}

// An unchanged triangle has no violation: it would have got a new vertex.
bool lms3dPatchMesher::Check(Work& work)
{
  work.Violations.clear();
  work.CoversOwnBeamsOnly = false;
  work.CheckedTriangles.resize(work.Triangulation.GetNumberOfTriangles(), { -1, -1, -1 });
  for (int i = 0; i < work.Triangulation.GetNumberOfTriangles(); ++i)
  {
    if (!work.Triangulation.IsInside(i))
    {
      continue;
    }
    std::array<std::int32_t, 3>& checked = work.CheckedTriangles[i];
    if (checked != work.Triangulation.GetCorners(i))
    {
      checked = work.Triangulation.GetCorners(i);
      if (!this->CheckTriangle(work, i))
      {
        return false;
      }
    }
  }
  work.CoversOwnBeamsOnly = true;
  return work.Covered == work.Members || !this->Sphere.IsRegular();
}

std::vector<lms3dPatchMesher::GridIndex> lms3dPatchMesher::FindUncovered(int patch) const
{
  std::vector<GridIndex> uncovered;
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (this->Patches.Labels[index] == patch && this->States[index] == IsUncovered &&
      !this->Sphere.IsPoleCopy(index) && !this->Sphere.IsFilled(index))
    {
      uncovered.push_back(index);
    }
  }
  return uncovered;
}

// Returns false if a vertex cannot be inserted.
bool lms3dPatchMesher::InsertBeams(Work& work)
{
  for (const Work::Violation& violation : work.Violations)
  {
    if (this->States[violation.Beam] == IsVertex)
    {
      continue; // On the edge of two triangles.
    }
    this->States[violation.Beam] = IsVertex;
    // A beam that is not regular can hit the triangle beside the direction of its return.
    if (!work.Triangulation.Insert(
          this->MakeVertex(violation.Beam, violation.Range), violation.Triangle) &&
      this->Sphere.IsRegular())
    {
      return false;
    }
  }
  return true;
}

// The vertex of a beam whose hit is too far from the return.
lms3dMapVertex lms3dPatchMesher::MakeVertex(GridIndex beam, double hit) const
{
  const double range = this->Sphere.GetRangeOnBeam(beam);
  const double halfSpread = this->Sphere.GetPoleHalfSpread(this->Sphere.GetRow(beam));
  const double lift = std::max(0.0, this->MaximumLift - halfSpread);
  const double lifted = hit > range ? range + lift : range - lift;
  return lms3dPatchTriangulation::MakeVertex(
    this->Sphere, beam, lifted > 0.0 && hit > 0.0 ? lifted : range);
}
