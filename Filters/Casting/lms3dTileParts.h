// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles that may be the nearest in each of sixteen tiles.
 */
#ifndef lms3dTileParts_h
#define lms3dTileParts_h

#include "Kernels/lms3dPacketKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// A triangle that may be the nearest in a tile.
struct lms3dTileCandidate
{
  std::int32_t Triangle;

  /// Whether it certainly meets all directions of the tile.
  bool Covers;
};

using lms3dTileCandidates = std::vector<lms3dTileCandidate>;

/// The candidates of sixteen tiles.
class lms3dTileParts
{
public:
  void Clear()
  {
    for (lms3dTileCandidates& candidates : this->Candidates)
    {
      candidates.clear();
    }
    this->Covers.fill(NoCover);
  }

  /// Adds what a triangle does to the tiles.
  void Add(std::int32_t triangle, const lms3dTileMasks& masks)
  {
    for (int i = 0; masks.Met >> i != 0; ++i)
    {
      if ((masks.Nearest >> i) & 1u)
      {
        this->SetCover(i, triangle);
      }
      else if ((masks.Met >> i) & 1u)
      {
        this->Candidates[i].push_back({ triangle, ((masks.Covered >> i) & 1u) != 0 });
      }
    }
  }

  /// Moves the nearest cover of each tile to its first place, so that the next division drops at once
  /// what lies behind it. Call this once, after all triangles.
  void MoveCoversToFront()
  {
    for (int i = 0; i < lms3dTiles::Size; ++i)
    {
      if (this->Covers[i] != NoCover)
      {
        std::swap(this->Candidates[i][0], this->Candidates[i][this->Covers[i]]);
        this->Covers[i] = 0;
      }
    }
  }

  /// Returns whether all beams of a tile have the triangle of GetTriangle.
  bool IsDecided(int i) const
  {
    const std::size_t count = this->Candidates[i].size();
    return count == 0 || (count == 1 && this->Covers[i] != NoCover);
  }

  std::int32_t GetTriangle(int i) const
  {
    return this->Candidates[i].empty() ? lms3dBeamPacket::NoTriangle
                                       : this->Candidates[i][0].Triangle;
  }

  std::array<lms3dTileCandidates, lms3dTiles::Size> Candidates;

private:
  static constexpr int NoCover = -1;

  // The last cover lies behind the new one.
  void SetCover(int i, std::int32_t triangle)
  {
    if (this->Covers[i] == NoCover)
    {
      this->Covers[i] = static_cast<int>(this->Candidates[i].size());
      this->Candidates[i].push_back({ triangle, true });
    }
    this->Candidates[i][this->Covers[i]].Triangle = triangle;
  }

  /// Where the nearest cover of each tile stands in its candidates.
  std::array<int, lms3dTiles::Size> Covers;
};

#endif
