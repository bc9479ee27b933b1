// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts the beams of one scan for the method Exact.
 *
 * Whole tiles are decided where that pays (lms3dTileSearch). Embree finds candidates for all other
 * packets.
 */
#ifndef lms3dExactGridCaster_h
#define lms3dExactGridCaster_h

#include "Casting/lms3dBeamGrid.h"
#include "Casting/lms3dEmbreeCandidates.h"
#include "Casting/lms3dExactView.h"
#include "Casting/lms3dGridCaster.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dTileSearch.h"
#include "Casting/lms3dTriangleClusters.h"

#include <cstddef>
#include <cstdint>
#include <memory>

class lms3dExactGridCaster final : public lms3dGridCaster
{
public:
  /// `clusters` may be null. All other arguments, and the arrays of the grid, must outlive the
  /// object; candidates and refinement must be of the same mesh.
  lms3dExactGridCaster(const lms3dTriangleMesh& mesh, const lms3dEmbreeCandidates& candidates,
    const lms3dRangeRefinement& refinement, const lms3dTriangleClusters* clusters,
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid);

  // Nearly square rectangles, whose packets meet the same triangles, also where there are no tiles.
  int GetRows() const override { return lms3dTileSearch::PacketsPerSide; }

  int GetColumns() const override { return this->Columns; }

  int GetColumnsAtOnce() const override
  {
    return this->Tiles ? lms3dTileSearch::PacketsPerSide : MaximumPackets;
  }

  bool CastAtOnce(const lms3dPacketRectangle& tile, double minimumRange,
    const lms3dBeamHits& hits) const override;

  bool IsEmpty(const lms3dPacketRectangle& rectangle) const override;

  void FindNearest(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const override;

private:
  std::ptrdiff_t GetSlot(int turn, int beam) const
  {
    return static_cast<std::ptrdiff_t>(turn) * this->Grid.Beams + beam;
  }

  bool StoreNothing(const lms3dPacketRectangle& tile, const lms3dBeamHits& hits) const;
  bool StoreTriangle(const lms3dPacketRectangle& tile, std::int32_t triangle, double minimumRange,
    const lms3dBeamHits& hits) const;
  lms3dBeamsOfTile GetBeams(const lms3dPacketRectangle& tile) const;

  const lms3dEmbreeCandidates& Candidates;
  const lms3dRangeRefinement& Refinement;
  const lms3dBeamGrid Grid;
  const lms3dCone Cone;
  lms3dExactView View;

  /// Null if tiles do not pay.
  std::unique_ptr<lms3dTileSearch> Tiles;
  int Columns = MaximumPackets / lms3dTileSearch::PacketsPerSide;
};

#endif
