// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dExactGridCaster.h"

#include "Casting/lms3dGridCone.h"

#include <algorithm>
#include <limits>

namespace
{
// Measured: with more triangles per packet, it is faster to compute narrow triangles where beams
// need them.
constexpr std::size_t MaximumTrianglesPerPacket = 1;

// Measured: with more, packets share too few triangles for it to pay to keep what is computed,
// unless Embree casts each packet in parts, which meet the same triangles.
constexpr std::size_t MaximumTrianglesPerPacketToKeep = 64;
} // namespace

lms3dExactGridCaster::lms3dExactGridCaster(const lms3dTriangleMesh& mesh,
  const lms3dEmbreeCandidates& candidates, const lms3dRangeRefinement& refinement,
  const lms3dTriangleClusters* clusters, const lms3dRayOrigin& origin, const lms3dBeamGrid& grid)
  : Candidates(candidates)
  , Refinement(refinement)
  , Grid(grid)
  , Cone(candidates.GetCone(origin.Position))
  , View(mesh, origin, candidates.GetUnit())
{
  const std::size_t triangles = mesh.GetNumberOfTriangles();
  const bool areShared = triangles <= MaximumTrianglesPerPacketToKeep * grid.CountPackets();
  // From outside, a scene fills a small part of the view, and Embree misses it at once.
  const bool isInside = candidates.IsInBoundingSphere(origin.Position);
  if (isInside && triangles <= MaximumTrianglesPerPacket * grid.CountPackets())
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
  else if (areShared || lms3dGetPacketKernels().RaysAtOnce < lms3dBeamPacket::Size)
  {
    this->View.KeepNarrowTriangles();
  }
  if (!this->Tiles && areShared && isInside && clusters &&
    lms3dTileSearch::IsSuitable(grid, *clusters))
  {
    this->Tiles = lms3dTileSearch::New(this->View, grid, *clusters, candidates.GetNormalization());
    // Some tiles take long, and a thread must not be left alone with several of them.
    this->Columns = lms3dTileSearch::PacketsPerSide;
  }
}

bool lms3dExactGridCaster::CastAtOnce(
  const lms3dPacketRectangle& tile, double minimumRange, const lms3dBeamHits& hits) const
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

bool lms3dExactGridCaster::IsEmpty(const lms3dPacketRectangle& rectangle) const
{
  return (this->Tiles && this->Tiles->IsEmpty(rectangle)) ||
    (this->Grid.FanAxes && lms3dIsOutside(this->Cone, this->Grid, rectangle));
}

void lms3dExactGridCaster::FindNearest(
  const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const
{
  if (this->Tiles)
  {
    this->Candidates.Cast(this->View, packets, this->Tiles->FindNearest(rectangle, packets));
  }
  else
  {
    this->Candidates.Cast(
      this->View, packets, lms3dGetFirstPackets(rectangle.Rows * rectangle.Columns));
  }
}

bool lms3dExactGridCaster::StoreNothing(
  const lms3dPacketRectangle& tile, const lms3dBeamHits& hits) const
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
bool lms3dExactGridCaster::StoreTriangle(const lms3dPacketRectangle& tile, std::int32_t triangle,
  double minimumRange, const lms3dBeamHits& hits) const
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
    std::fill_n(
      hits.Triangles + this->GetSlot(tile.FirstTurn + turn, tile.FirstBeam), beams.Beams, triangle);
  }
  return true;
}

lms3dBeamsOfTile lms3dExactGridCaster::GetBeams(const lms3dPacketRectangle& tile) const
{
  constexpr int Side = lms3dBeamGrid::Side;
  return { this->Grid.Cosines + tile.FirstBeam, this->Grid.Sines + tile.FirstBeam,
    this->Grid.FanAxes + tile.FirstTurn, this->Grid.Up.data(),
    std::min(tile.Rows * Side, this->Grid.Turns - tile.FirstTurn),
    std::min(tile.Columns * Side, this->Grid.Beams - tile.FirstBeam) };
}
