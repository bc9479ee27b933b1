// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeCandidates.h"
#include "Casting/lms3dExactView.h"
#include "Casting/lms3dFreeRangeRefinement.h"
#include "Casting/lms3dGridCone.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTileSearch.h"
#include "Casting/lms3dTriangleClusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace
{
// Measured: with more triangles per packet, it is faster to compute narrow triangles where beams
// need them.
constexpr std::size_t MaximumTrianglesPerPacket = 1;

// Measured: in larger scenes, clusters hardly help. They take about 10 bytes for each triangle.
constexpr std::size_t MaximumTrianglesInClusters = 200000;

// Returns the first packets.
lms3dPacketMask GetFirst(int count)
{
  return ~lms3dPacketMask() >> (lms3dGridCaster::MaximumPackets - count);
}

/// Decides whole tiles where that pays. Embree finds candidates for all other packets.
class ExactGridCaster final : public lms3dGridCaster
{
public:
  /// `clusters` may be null.
  ExactGridCaster(const lms3dTriangleMesh& mesh, const lms3dEmbreeCandidates& candidates,
    const lms3dRangeRefinement& refinement, const lms3dTriangleClusters* clusters,
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid)
    : Candidates(candidates)
    , Refinement(refinement)
    , Grid(grid)
    , Cone(candidates.GetCone(origin.Position))
    , View(mesh, origin, candidates.GetUnit())
  {
    const std::size_t triangles = mesh.GetNumberOfTriangles();
    // From outside, a scene fills a small part of the view, and Embree misses it at once.
    if (triangles <= MaximumTrianglesPerPacket * grid.CountPackets() &&
      candidates.IsInBoundingSphere(origin.Position))
    {
      if (lms3dTileSearch::IsSuitable(grid, triangles))
      {
        this->Tiles = lms3dTileSearch::New(this->View, grid);
      }
      else
      {
        this->View.MakeNarrowTriangles();
      }
    }
    else
    {
      this->View.KeepNarrowTriangles();
    }
    if (!this->Tiles && clusters && candidates.IsInBoundingSphere(origin.Position) &&
      lms3dTileSearch::IsSuitable(grid, *clusters))
    {
      this->Tiles =
        lms3dTileSearch::New(this->View, grid, *clusters, candidates.GetNormalization());
      // Some tiles take long, and a thread must not be left alone with several of them.
      this->Columns = lms3dTileSearch::PacketsPerSide;
    }
  }

  // Nearly square rectangles, whose packets meet the same triangles, also where there are no tiles.
  int GetRows() const override { return lms3dTileSearch::PacketsPerSide; }

  int GetColumns() const override { return this->Columns; }

  int GetColumnsAtOnce() const override
  {
    return this->Tiles ? lms3dTileSearch::PacketsPerSide : MaximumPackets;
  }

  bool CastAtOnce(
    const lms3dPacketRectangle& tile, double minimumRange, const lms3dBeamHits& hits) const override
  {
    std::int32_t triangle = lms3dBeamPacket::NoTriangle;
    if (!this->Tiles || !this->Tiles->IsDecided(tile.FirstTurn, tile.FirstBeam, triangle))
    {
      return false;
    }
    return triangle == lms3dBeamPacket::NoTriangle
      ? this->StoreNothing(tile, hits)
      : this->StoreTriangle(tile, triangle, minimumRange, hits);
  }

  bool IsEmpty(const lms3dPacketRectangle& rectangle) const override
  {
    return (this->Tiles && this->Tiles->IsEmpty(rectangle)) ||
      (this->Grid.FanAxes && lms3dIsOutside(this->Cone, this->Grid, rectangle));
  }

  void FindNearest(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const override
  {
    if (this->Tiles)
    {
      this->Candidates.Cast(this->View, packets, this->Tiles->FindNearest(rectangle, packets));
    }
    else
    {
      this->Candidates.Cast(this->View, packets, GetFirst(rectangle.Rows * rectangle.Columns));
    }
  }

private:
  std::ptrdiff_t GetSlot(int turn, int beam) const
  {
    return static_cast<std::ptrdiff_t>(turn) * this->Grid.Beams + beam;
  }

  bool StoreNothing(const lms3dPacketRectangle& tile, const lms3dBeamHits& hits) const
  {
    const lms3dBeamsOfTile beams = this->GetBeams(tile);
    for (int turn = 0; turn < beams.Turns; ++turn)
    {
      const std::ptrdiff_t slot = this->GetSlot(tile.FirstTurn + turn, tile.FirstBeam);
      std::fill_n(hits.Ranges + slot, beams.Beams, std::numeric_limits<double>::quiet_NaN());
      std::fill_n(hits.Triangles + slot, beams.Beams, lms3dBeamPacket::NoTriangle);
    }
    return true;
  }

  // Returns false if a range does not count.
  bool StoreTriangle(const lms3dPacketRectangle& tile, std::int32_t triangle, double minimumRange,
    const lms3dBeamHits& hits) const
  {
    const lms3dBeamsOfTile beams = this->GetBeams(tile);
    const lms3dRayOrigin& origin = this->View.GetOrigin();
    if (!this->Refinement.FillTile(origin, triangle, beams, { minimumRange, origin.MaximumRange },
          hits.Ranges + this->GetSlot(tile.FirstTurn, tile.FirstBeam), this->Grid.Beams))
    {
      return false;
    }
    for (int turn = 0; turn < beams.Turns; ++turn)
    {
      std::fill_n(hits.Triangles + this->GetSlot(tile.FirstTurn + turn, tile.FirstBeam),
        beams.Beams, triangle);
    }
    return true;
  }

  lms3dBeamsOfTile GetBeams(const lms3dPacketRectangle& tile) const
  {
    constexpr int Side = lms3dBeamGrid::Side;
    return { this->Grid.Cosines + tile.FirstBeam, this->Grid.Sines + tile.FirstBeam,
      this->Grid.FanAxes + tile.FirstTurn, this->Grid.Up.data(),
      std::min(tile.Rows * Side, this->Grid.Turns - tile.FirstTurn),
      std::min(tile.Columns * Side, this->Grid.Beams - tile.FirstBeam) };
  }

  const lms3dEmbreeCandidates& Candidates;
  const lms3dRangeRefinement& Refinement;
  const lms3dBeamGrid Grid;
  const lms3dCone Cone;
  lms3dExactView View;
  std::unique_ptr<lms3dTileSearch> Tiles;
  int Columns = MaximumPackets / lms3dTileSearch::PacketsPerSide;
};

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
      this->Candidates.Cast(view, packets + first, GetFirst(std::min(AtOnce, count - first)));
    }
  }

  std::unique_ptr<lms3dGridCaster> NewGridCaster(
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid) const override
  {
    return std::make_unique<ExactGridCaster>(
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
