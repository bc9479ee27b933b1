// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides for whole tiles of a scan at once which triangle is the nearest.
 *
 * Source of the idea: J. Warnock, "A hidden surface algorithm for computer generated halftone
 * pictures", 1969. The grid of beams is divided three times: into blocks of 64 x 64 beams, tiles of
 * 16 x 16, and packets of 4 x 4. Each step decides for 16 parts at once which triangles they can meet.
 * A triangle that covers a part hides all that lies behind it there. If nothing else is left, the part
 * is decided, without a look at its beams.
 */
#ifndef lms3dTileSearch_h
#define lms3dTileSearch_h

#include "Casting/lms3dBeamGrid.h"
#include "Casting/lms3dExactView.h"
#include "Casting/lms3dGridCaster.h"
#include "Casting/lms3dTileCandidateLists.h"
#include "Casting/lms3dTileGrid.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class lms3dTileSearch
{
public:
  /// The packets along each side of a tile.
  static constexpr int PacketsPerSide = lms3dTileGrid::TileSide / lms3dBeamGrid::Side;

  /// Returns whether the search can divide a grid, and whether that can pay for a number of triangles.
  /// The answer does not depend on the machine.
  static bool IsSuitable(const lms3dBeamGrid& grid, std::size_t triangles);

  /**
   * Divides the grid into tiles, with the threads of the calling TBB arena. The view must have its
   * narrow triangles. Returns null if too many triangles remain for this to pay. View and the arrays of
   * the grid must outlive the object.
   */
  static std::unique_ptr<lms3dTileSearch> New(
    const lms3dExactView& view, const lms3dBeamGrid& grid);

  /// Casts a packet that the search does not decide.
  using CastPacket = std::function<void(lms3dBeamPacket&)>;

  /// Sets Triangle of the packets of some tiles side by side. The rectangle begins where a tile begins,
  /// and has at most PacketsPerSide rows. Several threads may call this at once.
  void FindNearest(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets,
    const CastPacket& castPacket) const;

private:
  struct PacketsOfTile;

  /// The candidates of a block's tiles, one tile after the other, where the list of each tile begins, and
  /// the tiles that are decided.
  struct Block
  {
    lms3dTileCandidates Candidates;
    std::array<std::uint32_t, lms3dTiles::Size + 1> First;
    std::uint32_t Decided;
  };

  lms3dTileSearch(const lms3dExactView& view, const lms3dBeamGrid& grid);
  bool Divide();
  std::vector<lms3dTileCandidates> DivideGrid() const;
  Block DivideBlock(int number, const lms3dTileCandidates& candidates) const;
  lms3dTileCandidateLists ClassifyParts(const lms3dTileCandidate* candidates, std::size_t count,
    std::uint32_t present, lms3dTiles& tiles) const;
  void FindInTile(const PacketsOfTile& packets, const CastPacket& castPacket) const;
  void FindInParts(const lms3dTileCandidate* candidates, std::size_t count,
    const PacketsOfTile& packets, const CastPacket& castPacket) const;
  void TestCandidates(const lms3dTileCandidates& candidates, lms3dBeamPacket& packet) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dExactView& View;
  const lms3dTileGrid Grid;
  std::vector<lms3dCornerDirections> Corners;
  std::vector<Block> Blocks;
};

#endif
