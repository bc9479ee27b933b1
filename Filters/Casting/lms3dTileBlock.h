// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is known about the sixteen tiles of a block.
 */
#ifndef lms3dTileBlock_h
#define lms3dTileBlock_h

#include "Casting/lms3dTileCandidateLists.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>
#include <cstdint>

struct lms3dTileBlock
{
  lms3dTileBlock() = default;

  explicit lms3dTileBlock(const lms3dTileCandidateLists& tiles)
    : Decided(tiles.GetDecided())
  {
    tiles.GetCandidates(this->Candidates, this->First);
  }

  /// Returns the first candidate of a tile, or lms3dBeamPacket::NoTriangle.
  std::int32_t GetTriangle(int tile) const
  {
    const std::uint32_t first = this->First[tile];
    return first == this->First[tile + 1] ? lms3dBeamPacket::NoTriangle
                                          : this->Candidates[first].Triangle;
  }

  /// Ends the list of candidates of a tile.
  void EndTile(int tile)
  {
    this->First[tile + 1] = static_cast<std::uint32_t>(this->Candidates.size());
  }

  /// The triangles that a tile can meet, one tile after the other, and where the list of each tile
  /// begins.
  lms3dTileCandidates Candidates;
  std::array<std::uint32_t, lms3dTiles::Size + 1> First = {};

  /// The tiles all of whose beams hit their only candidate, or have none and hit nothing.
  std::uint32_t Decided = 0;

  /// The tiles that can meet more triangles than pay. Their lists are empty.
  std::uint32_t Crowded = 0;
};

#endif
