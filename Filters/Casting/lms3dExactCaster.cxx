// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeCandidates.h"
#include "Casting/lms3dExactGridCaster.h"
#include "Casting/lms3dExactView.h"
#include "Casting/lms3dFreeRangeRefinement.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangleClusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace
{
// Measured: in larger scenes, clusters hardly help. They take about 10 bytes for each triangle.
constexpr std::size_t MaximumTrianglesInClusters = 200000;

/// Embree finds candidates, lms3dExactView decides. Once the nearest triangle is known, its range
/// is computed again with more digits.
class ExactCaster final : public lms3dRayCaster
{
public:
  ExactCaster(lms3dTriangleMesh mesh, const lms3dProgress& progress)
    : lms3dRayCaster(std::move(mesh))
    , Candidates(this->GetMesh(), progress)
    , Refinement(this->GetMesh())
  {
    if (this->GetMesh().GetNumberOfTriangles() <= MaximumTrianglesInClusters &&
      std::isfinite(this->Candidates.GetUnit()) && !this->Candidates.HasOutliers())
    {
      this->Clusters = std::make_unique<lms3dTriangleClusters>(
        this->GetMesh(), this->Candidates.GetNormalization());
    }
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    const lms3dExactView view = this->MakeView(origin);
    constexpr int AtOnce = lms3dGridCaster::MaximumPackets;
    for (int first = 0; first < count; first += AtOnce)
    {
      this->Candidates.Cast(
        view, packets + first, lms3dGetFirstPackets(std::min(AtOnce, count - first)));
    }
  }

  std::unique_ptr<lms3dGridCaster> NewGridCaster(
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid) const override
  {
    return std::make_unique<lms3dExactGridCaster>(
      this->GetMesh(), this->Candidates, this->Refinement, this->Clusters.get(), origin, grid);
  }

  void ComputeRanges(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    const lms3dExactView view = this->MakeView(origin);
    for (int i = 0; i < count; ++i)
    {
      view.ComputeRanges(packets[i]);
    }
  }

  void RefineRanges(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    this->Refinement.Refine(origin, packets, count);
  }

  void FindNearestFree(double maximumRange, lms3dFreePacket* packets, int count) const override
  {
    this->Candidates.CastFree(maximumRange, packets, count);
  }

  void RefineRangesFree(lms3dFreePacket* packets, int count) const override
  {
    lms3dRefineFreeRanges(this->GetMesh(), packets, count);
  }

private:
  lms3dExactView MakeView(const lms3dRayOrigin& origin) const
  {
    return { this->GetMesh(), origin, this->Candidates.GetUnit() };
  }

  const lms3dEmbreeCandidates Candidates;
  const lms3dRangeRefinement Refinement;

  /// Null if the scene is too large, or has outliers.
  std::unique_ptr<lms3dTriangleClusters> Clusters;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewExactCaster(
  lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  return std::make_unique<ExactCaster>(std::move(mesh), progress);
}
