// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles that may be the nearest in each of sixteen tiles.
 */
#ifndef lms3dTileCandidateLists_h
#define lms3dTileCandidateLists_h

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

/// A triangle that may be the nearest in a tile.
struct lms3dTileCandidate
{
  std::int32_t Triangle;

  /// Whether it certainly meets all directions of the tile.
  bool Covers;
};

using lms3dTileCandidates = std::vector<lms3dTileCandidate>;

/// The candidates of sixteen tiles. Sets of tiles are masks, as in lms3dTile.h.
class lms3dTileCandidateLists
{
public:
  /// `count` is how many triangles will be added at most.
  explicit lms3dTileCandidateLists(std::size_t count)
  {
    this->Triangles.reserve(count);
    this->Covers.fill(NoCover);
  }

  /// Adds what a triangle does to the tiles.
  void Add(std::int32_t triangle, const lms3dTileMasks& masks)
  {
    if (masks.Met != 0)
    {
      this->SetCovers(masks.Nearest);
      this->Triangles.push_back({ triangle, masks.Met, masks.Covered });
    }
  }

  /// Returns the tiles all of whose beams hit their only candidate, or have none and hit nothing.
  std::uint32_t GetDecided() const
  {
    std::uint32_t once = 0;
    std::uint32_t twice = 0;
    for (const Triangle& triangle : this->Triangles)
    {
      twice |= once & triangle.Met;
      once |= triangle.Met;
    }
    return ~once | (~twice & this->Covered);
  }

  /// Sets `candidates` to the candidates of all tiles, one tile after the other, and `first` to
  /// where each tile's begin. The nearest one that covers a tile comes first, so that the next
  /// division drops at once what lies behind it.
  void GetCandidates(
    lms3dTileCandidates& candidates, std::array<std::uint32_t, lms3dTiles::Size + 1>& first) const
  {
    first.fill(0u);
    this->ForEachPair([&first](int, int tile) { ++first[tile + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::array<std::uint32_t, lms3dTiles::Size> next = {};
    for (int tile = 0; tile < lms3dTiles::Size; ++tile)
    {
      next[tile] = first[tile] + (this->Covers[tile] == NoCover ? 0u : 1u);
    }
    candidates.resize(first.back());
    this->ForEachPair(
      [&](int i, int tile)
      {
        const Triangle& triangle = this->Triangles[i];
        const std::uint32_t place = i == this->Covers[tile] ? first[tile] : next[tile]++;
        candidates[place] = { triangle.Number, lms3dHasBit(triangle.Covered, tile) };
      });
  }

  /// Returns the nearest triangle that covers a tile, or lms3dBeamPacket::NoTriangle.
  std::int32_t GetCover(int tile) const
  {
    const int cover = this->Covers[tile];
    return cover == NoCover ? lms3dBeamPacket::NoTriangle : this->Triangles[cover].Number;
  }

  /// Calls `function` with the number of each candidate of a tile, in the order of GetCandidates.
  template <typename Function>
  void ForEachCandidate(int tile, const Function& function) const
  {
    const int cover = this->Covers[tile];
    if (cover != NoCover)
    {
      function(this->Triangles[cover].Number);
    }
    for (int i = 0; i < static_cast<int>(this->Triangles.size()); ++i)
    {
      if (lms3dHasBit(this->Triangles[i].Met, tile) && i != cover)
      {
        function(this->Triangles[i].Number);
      }
    }
  }

private:
  static constexpr int NoCover = -1;

  struct Triangle
  {
    std::int32_t Number;
    std::uint32_t Met;
    std::uint32_t Covered;
  };

  // The next triangle becomes the cover of some tiles. It hides their last cover there.
  void SetCovers(std::uint32_t tiles)
  {
    this->Covered |= tiles;
    for (; tiles != 0; tiles &= tiles - 1)
    {
      int& cover = this->Covers[lms3dGetFirstBit(tiles)];
      if (cover != NoCover)
      {
        this->Triangles[cover].Met &= ~(tiles & -tiles);
      }
      cover = static_cast<int>(this->Triangles.size());
    }
  }

  // Calls `function` with where a triangle stands in Triangles and a tile that it may meet, for all
  // such pairs.
  template <typename Function>
  void ForEachPair(const Function& function) const
  {
    for (int i = 0; i < static_cast<int>(this->Triangles.size()); ++i)
    {
      for (std::uint32_t rest = this->Triangles[i].Met; rest != 0; rest &= rest - 1)
      {
        function(i, lms3dGetFirstBit(rest));
      }
    }
  }

  std::vector<Triangle> Triangles;

  /// The tiles that a triangle covers, and for each, where the nearest stands in Triangles.
  std::uint32_t Covered = 0;
  std::array<int, lms3dTiles::Size> Covers;
};

#endif
