// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dRayCheck.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace
{
using GridIndex = lms3dRayCheck::GridIndex;

// Radians. Larger than the rounding of vertices.
constexpr double Margin = 1e-6;

/// The check of one patch while triangles are added.
class Checker
{
public:
  Checker(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, int patch, double maximumError)
    : Sphere(sphere)
    , Patches(patches)
    , Patch(patch)
    , MaximumError(maximumError)
  {
  }

  void AddTriangle(
    const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c)
  {
    const lms3dTriangleRasterizer beams(this->Sphere, a, b, c, Margin);
    const auto visit = [&](int column, int first, int last)
    {
      const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
      for (int row = first; row <= last; ++row)
      {
        const GridIndex index = this->Sphere.GetIndex(column, row);
        if (this->Sphere.IsFilled(index))
        {
          continue;
        }
        const double hit = hits.GetRange(row);
        const lms3dVector point =
          lms3dScale(this->Sphere.GetDirection(index), this->Sphere.GetRange(index));
        const double distance = lms3dGetDistance(point, a.Position, b.Position, c.Position);
        // The margin of the beam can be far from a triangle at a grazing angle.
        if (this->IsWithin(index, hit) && distance <= this->MaximumError)
        {
          this->AddHit(index, distance);
        }
        else if (this->IsBlocked(index, hit))
        {
          this->Result.Blocked.push_back(index);
        }
      }
    };
    beams.ForEachColumn(visit);
  }

  lms3dRayCheck GetResult(int members)
  {
    KeepNearest(this->Own);
    KeepNearest(this->Result.Others);
    for (const lms3dRayCheck::Hit& hit : this->Own)
    {
      const bool isPole = this->Sphere.IsPoleRow(this->Sphere.GetRow(hit.first));
      this->Result.LargestDeviation =
        std::max(this->Result.LargestDeviation, isPole ? 0.0 : hit.second);
    }
    if (static_cast<int>(this->Own.size()) < members)
    {
      this->FindUncovered();
    }
    return std::move(this->Result);
  }

private:
  bool IsWithin(GridIndex index, double hit) const
  {
    return this->Sphere.HasReturn(index) && !this->Sphere.IsPoleCopy(index) &&
      std::abs(this->Sphere.GetRangeOnBeam(index) - hit) +
        this->Sphere.GetPoleHalfSpread(this->Sphere.GetRow(index)) <=
      this->MaximumError;
  }

  void AddHit(GridIndex index, double distance)
  {
    (this->Patches.Labels[index] == this->Patch ? this->Own : this->Result.Others)
      .emplace_back(index, distance);
  }

  // Whether the device measured with a beam of another patch, and found nothing near the hit.
  // Returns beyond the axis have no place in the grid.
  bool IsBlocked(GridIndex index, double hit) const
  {
    const bool isMeasured = this->Sphere.GetBeam(index) >= 0 && this->Sphere.GetTurn(index) >= 0 &&
      !this->Sphere.IsPoleCopy(index);
    return isMeasured && this->Patches.Labels[index] != this->Patch &&
      (this->Sphere.HasReturn(index) ? hit < this->Sphere.GetRangeOnBeam(index)
                                     : !this->Sphere.GetRays().IsVertical(index));
  }

  // Sorts the hits, and keeps the nearest of each beam.
  static void KeepNearest(std::vector<lms3dRayCheck::Hit>& hits)
  {
    std::sort(hits.begin(), hits.end());
    const auto isSame = [](const lms3dRayCheck::Hit& a, const lms3dRayCheck::Hit& b)
    { return a.first == b.first; };
    hits.erase(std::unique(hits.begin(), hits.end(), isSame), hits.end());
  }

  void FindUncovered()
  {
    auto next = this->Own.begin();
    for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
    {
      const bool isCovered = next != this->Own.end() && next->first == index;
      next += isCovered ? 1 : 0;
      if (!isCovered && this->Patches.Labels[index] == this->Patch &&
        !this->Sphere.IsPoleCopy(index) && !this->Sphere.IsFilled(index))
      {
        this->Result.Uncovered.push_back(index);
      }
    }
  }

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const int Patch;
  const double MaximumError;
  lms3dRayCheck Result;
  /// The hits of the patch's own beams within the bound.
  std::vector<lms3dRayCheck::Hit> Own;
};
} // namespace

lms3dRayCheck lms3dCheckRays(const lms3dBeamSphere& sphere, const lms3dPatches& patches, int patch,
  int members, const lms3dPatchTriangulation& triangulation, double maximumError)
{
  Checker checker(sphere, patches, patch, maximumError);
  for (int i = 0; i < triangulation.GetNumberOfTriangles(); ++i)
  {
    if (triangulation.IsInside(i))
    {
      const std::array<std::int32_t, 3>& corners = triangulation.GetCorners(i);
      checker.AddTriangle(triangulation.GetVertex(corners[0]), triangulation.GetVertex(corners[1]),
        triangulation.GetVertex(corners[2]));
    }
  }
  return checker.GetResult(members);
}
