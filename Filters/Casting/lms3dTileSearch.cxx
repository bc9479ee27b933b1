// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTileSearch.h"

#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangle.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace
{
// Measured: above one of these numbers, Embree is faster.
constexpr std::size_t MaximumTriangles = 5000;
constexpr double MaximumCandidatesPerPacket = 0.75;
constexpr std::size_t MaximumCandidatesOfTile = 64;
constexpr std::size_t MaximumCandidatesOfPacket = 16;

// Enough for the preparations of a task to cost little.
constexpr std::size_t TrianglesOfTask = 64;
} // namespace

/// The packets of one tile, in an array that has the packets of several tiles side by side.
struct lms3dTileSearch::PacketsOfTile
{
  // Calls `function` with the number of the part that a packet is, and the packet.
  template <typename Function>
  void ForEach(const Function& function) const
  {
    for (int row = 0; row < this->Tile.Rows; ++row)
    {
      for (int column = 0; column < this->Tile.Columns; ++column)
      {
        function(PacketsPerSide * row + column, this->First[row * this->Stride + column]);
      }
    }
  }

  lms3dPacketRectangle Tile;
  lms3dBeamPacket* First;

  /// How far the rows of packets are apart in the array.
  int Stride;
};

bool lms3dTileSearch::IsSuitable(const lms3dBeamGrid& grid, std::size_t triangles)
{
  return grid.FanAxes && triangles <= MaximumTriangles && triangles <= grid.CountPackets() &&
    lms3dTileGrid::CanDivide(grid);
}

std::unique_ptr<lms3dTileSearch> lms3dTileSearch::New(
  const lms3dExactView& view, const lms3dBeamGrid& grid)
{
  std::unique_ptr<lms3dTileSearch> search(new lms3dTileSearch(view, grid));
  return search->Divide() ? std::move(search) : nullptr;
}

lms3dTileSearch::lms3dTileSearch(const lms3dExactView& view, const lms3dBeamGrid& grid)
  : View(view)
  , Grid(grid)
  , Corners(view.GetMesh().GetNumberOfTriangles())
{
}

bool lms3dTileSearch::Divide()
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, this->Corners.size(), TrianglesOfTask),
    [this](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        this->Corners[i] = lms3dGetCornerDirections(lms3dToSensorFrame(
          lms3dGetCorners(this->View.GetMesh(), i), this->View.GetOrigin().Position));
      }
    });
  const std::vector<lms3dTileCandidates> candidates = this->DivideGrid();
  std::size_t total = 0;
  for (const lms3dTileCandidates& ofBlock : candidates)
  {
    total += ofBlock.size();
  }
  if (static_cast<double>(total) >
    MaximumCandidatesPerPacket * static_cast<double>(this->Grid.GetBeams().CountPackets()))
  {
    return false;
  }
  this->Blocks.resize(candidates.size());
  tbb::parallel_for(0, this->Grid.GetNumberOfBlocks(),
    [&](int block) { this->Blocks[block] = this->DivideBlock(block, candidates[block]); });
  return true;
}

std::vector<lms3dTileCandidates> lms3dTileSearch::DivideGrid() const
{
  lms3dTileCandidates all(this->Corners.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = { static_cast<std::int32_t>(i), false };
  }
  std::vector<lms3dTileCandidates> candidates(this->Grid.GetNumberOfBlocks());
  const int groups = (this->Grid.GetNumberOfBlocks() - 1) / lms3dTiles::Size + 1;
  tbb::parallel_for(0, groups,
    [&](int group)
    {
      const int first = group * lms3dTiles::Size;
      const int count = std::min(lms3dTiles::Size, this->Grid.GetNumberOfBlocks() - first);
      lms3dTiles tiles;
      for (int i = 0; i < lms3dTiles::Size; ++i)
      {
        this->Grid.FillTile(
          this->Grid.GetBlock(std::min(first + i, this->Grid.GetNumberOfBlocks() - 1)), i, tiles);
      }
      const lms3dTileCandidateLists parts =
        this->ClassifyParts(all.data(), all.size(), (1u << count) - 1u, tiles);
      for (int i = 0; i < count; ++i)
      {
        parts.AppendCandidates(i, candidates[first + i]);
      }
    });
  return candidates;
}

lms3dTileSearch::Block lms3dTileSearch::DivideBlock(
  int number, const lms3dTileCandidates& candidates) const
{
  lms3dTiles tiles;
  const std::uint32_t present = this->Grid.FillParts(this->Grid.GetBlock(number), tiles);
  const lms3dTileCandidateLists parts =
    this->ClassifyParts(candidates.data(), candidates.size(), present, tiles);
  Block block = { {}, {}, parts.GetDecided() };
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    parts.AppendCandidates(i, block.Candidates);
    block.First[i + 1] = static_cast<std::uint32_t>(block.Candidates.size());
  }
  return block;
}

lms3dTileCandidateLists lms3dTileSearch::ClassifyParts(const lms3dTileCandidate* candidates,
  std::size_t count, std::uint32_t present, lms3dTiles& tiles) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    tiles.Up[axis] = static_cast<float>(this->Grid.GetBeams().Up[axis]);
  }
  this->Kernels.FillTileCorners(tiles);
  lms3dTileCandidateLists parts(count);
  lms3dTileCover cover = {};
  for (std::size_t i = 0; i < count; ++i)
  {
    const lms3dTileCandidate& candidate = candidates[i];
    const lms3dTileMasks masks = this->Kernels.ClassifyTiles(tiles,
      this->View.GetNarrowTriangle(candidate.Triangle), this->Corners[candidate.Triangle],
      { present, candidate.Covers ? present : 0u, 0u }, this->View.GetMinimumInverse(), cover);
    parts.Add(candidate.Triangle, masks);
  }
  return parts;
}

void lms3dTileSearch::FindNearest(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets,
  const CastPacket& castPacket) const
{
  for (int column = 0; column < rectangle.Columns; column += PacketsPerSide)
  {
    const lms3dPacketRectangle tile = { rectangle.FirstTurn,
      rectangle.FirstBeam + column * lms3dBeamGrid::Side, rectangle.Rows,
      std::min(PacketsPerSide, rectangle.Columns - column) };
    this->FindInTile({ tile, packets + column, rectangle.Columns }, castPacket);
  }
}

void lms3dTileSearch::FindInTile(const PacketsOfTile& packets, const CastPacket& castPacket) const
{
  const lms3dPacketRectangle& tile = packets.Tile;
  const Block& block = this->Blocks[this->Grid.FindBlock(tile.FirstTurn, tile.FirstBeam)];
  const int part = lms3dTileGrid::FindPart(tile.FirstTurn, tile.FirstBeam);
  const lms3dTileCandidate* candidates = block.Candidates.data() + block.First[part];
  const std::size_t count = block.First[part + 1] - block.First[part];
  if (lms3dHasBit(block.Decided, part))
  {
    const std::int32_t triangle = count == 0 ? lms3dBeamPacket::NoTriangle : candidates[0].Triangle;
    packets.ForEach(
      [triangle](int, lms3dBeamPacket& packet) { lms3dSetTriangle(triangle, packet); });
  }
  else if (count > MaximumCandidatesOfTile)
  {
    packets.ForEach([&castPacket](int, lms3dBeamPacket& packet) { castPacket(packet); });
  }
  else
  {
    this->FindInParts(candidates, count, packets, castPacket);
  }
}

void lms3dTileSearch::FindInParts(const lms3dTileCandidate* candidates, std::size_t count,
  const PacketsOfTile& packets, const CastPacket& castPacket) const
{
  lms3dTiles tiles;
  const std::uint32_t present =
    this->Grid.FillParts({ 1, packets.Tile.FirstTurn, packets.Tile.FirstBeam }, tiles);
  const lms3dTileCandidateLists parts = this->ClassifyParts(candidates, count, present, tiles);
  const std::uint32_t decided = parts.GetDecided();
  lms3dTileCandidates ofPacket;
  ofPacket.reserve(count);
  packets.ForEach(
    [&](int i, lms3dBeamPacket& packet)
    {
      if (lms3dHasBit(decided, i))
      {
        lms3dSetTriangle(parts.GetTriangle(i), packet);
        return;
      }
      ofPacket.clear();
      parts.AppendCandidates(i, ofPacket);
      if (ofPacket.size() > MaximumCandidatesOfPacket)
      {
        castPacket(packet);
      }
      else
      {
        this->TestCandidates(ofPacket, packet);
      }
    });
}

void lms3dTileSearch::TestCandidates(
  const lms3dTileCandidates& candidates, lms3dBeamPacket& packet) const
{
  lms3dPacketSearch search;
  this->View.Begin(packet, search);
  for (const lms3dTileCandidate& candidate : candidates)
  {
    this->View.Test(static_cast<std::uint32_t>(candidate.Triangle), packet.Active, search);
  }
}
