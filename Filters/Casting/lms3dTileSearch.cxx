// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTileSearch.h"

#include "Casting/lms3dClusterDivision.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangleDivision.h"

#include <algorithm>
#include <utility>

namespace
{
// Measured: above one of these numbers, Embree is faster.
constexpr std::size_t MaximumTriangles = 5000;
constexpr double MaximumCandidatesPerPacket = 0.75;
constexpr std::size_t MaximumClustersPerPacket = 2;
constexpr std::size_t MaximumCandidatesOfTile = 64;
} // namespace

/// The packets of one tile, in an array that has the packets of several tiles side by side.
struct lms3dTileSearch::PacketsOfTile
{
  // Calls `function` with the number of the part that a packet is, and the packet. Opens the
  // packets for which it returns false.
  template <typename Function>
  void ForEach(const Function& function) const
  {
    for (int row = 0; row < this->Tile.Rows; ++row)
    {
      for (int column = 0; column < this->Tile.Columns; ++column)
      {
        const int number = row * this->Stride + this->FirstColumn + column;
        if (!function(PacketsPerSide * row + column, this->Packets[number]))
        {
          this->Open.set(static_cast<std::size_t>(number));
        }
      }
    }
  }

  lms3dPacketRectangle Tile;
  lms3dBeamPacket* Packets;
  int FirstColumn;

  /// How far the rows of packets are apart in the array.
  int Stride;
  lms3dNarrowCache* Kept;
  lms3dPacketMask& Open;
};

bool lms3dTileSearch::IsSuitable(const lms3dBeamGrid& grid, std::size_t triangles)
{
  return grid.FanAxes && triangles <= MaximumTriangles && triangles <= grid.CountPackets() &&
    lms3dTileGrid::CanDivide(grid);
}

bool lms3dTileSearch::IsSuitable(const lms3dBeamGrid& grid, const lms3dTriangleClusters& clusters)
{
  return grid.FanAxes && clusters.GetCount() <= MaximumClustersPerPacket * grid.CountPackets() &&
    lms3dTileGrid::CanDivide(grid);
}

std::unique_ptr<lms3dTileSearch> lms3dTileSearch::New(
  lms3dExactView& view, const lms3dBeamGrid& grid)
{
  std::unique_ptr<lms3dTileSearch> search(new lms3dTileSearch(view, grid));
  const lms3dTriangleDivision division(view, search->Classifier, search->Grid);
  if (static_cast<double>(division.CountCandidates()) >
    MaximumCandidatesPerPacket * static_cast<double>(grid.CountPackets()))
  {
    return nullptr;
  }
  search->Blocks = division.Divide();
  return search;
}

std::unique_ptr<lms3dTileSearch> lms3dTileSearch::New(const lms3dExactView& view,
  const lms3dBeamGrid& grid, const lms3dTriangleClusters& clusters,
  const lms3dNormalization& normalization)
{
  std::unique_ptr<lms3dTileSearch> search(new lms3dTileSearch(view, grid));
  search->Blocks = lms3dClusterDivision(clusters, normalization, search->Classifier, search->Grid)
                     .Divide(MaximumCandidatesOfTile);
  return search;
}

lms3dTileSearch::lms3dTileSearch(const lms3dExactView& view, const lms3dBeamGrid& grid)
  : Classifier(view)
  , Grid(grid)
{
}

lms3dPacketMask lms3dTileSearch::FindNearest(
  const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const
{
  lms3dNarrowCache* const kept = this->Classifier.GetView().GetKept();
  lms3dPacketMask open;
  for (int column = 0; column < rectangle.Columns; column += PacketsPerSide)
  {
    const lms3dPacketRectangle tile = { rectangle.FirstTurn,
      rectangle.FirstBeam + column * lms3dBeamGrid::Side, rectangle.Rows,
      std::min(PacketsPerSide, rectangle.Columns - column) };
    this->FindInTile({ tile, packets, column, rectangle.Columns, kept, open });
  }
  return open;
}

bool lms3dTileSearch::IsDecided(int turn, int beam, std::int32_t& triangle) const
{
  const lms3dTileBlock& block = this->Blocks[this->Grid.FindBlock(turn, beam)];
  const int part = lms3dTileGrid::FindPart(turn, beam);
  triangle = block.GetTriangle(part);
  return lms3dHasBit(block.Decided, part);
}

bool lms3dTileSearch::IsEmpty(const lms3dPacketRectangle& rectangle) const
{
  for (int column = 0; column < rectangle.Columns; column += PacketsPerSide)
  {
    const int beam = rectangle.FirstBeam + column * lms3dBeamGrid::Side;
    std::int32_t triangle = lms3dBeamPacket::NoTriangle;
    if (!this->IsDecided(rectangle.FirstTurn, beam, triangle) ||
      triangle != lms3dBeamPacket::NoTriangle)
    {
      return false;
    }
  }
  return true;
}

void lms3dTileSearch::FindInTile(const PacketsOfTile& packets) const
{
  const lms3dPacketRectangle& tile = packets.Tile;
  std::int32_t triangle = lms3dBeamPacket::NoTriangle;
  if (this->IsDecided(tile.FirstTurn, tile.FirstBeam, triangle))
  {
    packets.ForEach(
      [triangle](int, lms3dBeamPacket& packet)
      {
        lms3dSetTriangle(triangle, packet);
        return true;
      });
    return;
  }
  const lms3dTileBlock& block = this->Blocks[this->Grid.FindBlock(tile.FirstTurn, tile.FirstBeam)];
  const int part = lms3dTileGrid::FindPart(tile.FirstTurn, tile.FirstBeam);
  const std::size_t count = block.First[part + 1] - block.First[part];
  if (count > MaximumCandidatesOfTile || lms3dHasBit(block.Crowded, part))
  {
    return packets.ForEach([](int, lms3dBeamPacket&) { return false; });
  }
  this->FindInParts(block.Candidates.data() + block.First[part], count, packets);
}

void lms3dTileSearch::FindInParts(
  const lms3dTileCandidate* candidates, std::size_t count, const PacketsOfTile& packets) const
{
  lms3dTiles tiles;
  const std::uint32_t present =
    this->Grid.FillParts({ 1, packets.Tile.FirstTurn, packets.Tile.FirstBeam }, tiles);
  const lms3dTileCandidateLists parts =
    this->Classifier.Classify(candidates, count, present, tiles, packets.Kept);
  const std::uint32_t decided = parts.GetDecided();
  packets.ForEach(
    [&](int i, lms3dBeamPacket& packet)
    {
      if (lms3dHasBit(decided, i))
      {
        lms3dSetTriangle(parts.GetCover(i), packet);
      }
      else
      {
        this->TestCandidates(parts, i, packets.Kept, packet);
      }
      return true;
    });
}

void lms3dTileSearch::TestCandidates(const lms3dTileCandidateLists& parts, int part,
  lms3dNarrowCache* kept, lms3dBeamPacket& packet) const
{
  lms3dPacketSearch search;
  search.Kept = kept;
  this->Classifier.GetView().Begin(packet, search);
  parts.ForEachCandidate(part,
    [&](std::int32_t triangle) {
      this->Classifier.GetView().Test(static_cast<std::uint32_t>(triangle), packet.Active, search);
    });
}
