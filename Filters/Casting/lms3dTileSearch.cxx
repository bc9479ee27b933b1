// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTileSearch.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// A packet's three ancestors have 4, 16 and 64 turns and beams: level 2, 1 and 0.
constexpr int BlockSide = 4 * lms3dTileSearch::TileSide;

// The turns of a block span at most this angle, degrees. Beyond 180, a tile would be no cone.
constexpr double MaximumBlockAngle = 90.0;

// Measured: above one of these numbers, Embree is faster.
constexpr std::size_t MaximumTriangles = 5000;
constexpr double MaximumCandidatesPerPacket = 0.75;
constexpr std::size_t MaximumCandidatesOfTile = 64;
constexpr std::size_t MaximumCandidatesOfPacket = 16;

// Covers the rounding of a cosine to single precision.
constexpr double CosineMargin = 1.0 - 1e-6;

int CountBlocks(int turnsOrBeams)
{
  return (turnsOrBeams - 1) / BlockSide + 1;
}

std::size_t CountPackets(const lms3dBeamGrid& grid)
{
  return static_cast<std::size_t>(lms3dBeamGrid::CountPackets(grid.Turns)) *
    lms3dBeamGrid::CountPackets(grid.Beams);
}

lms3dCornerDirections GetCornerDirections(
  const lms3dTriangleMesh& mesh, std::size_t triangle, const double origin[3])
{
  lms3dCornerDirections directions;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* point = mesh.GetCorner(triangle, corner);
    double seen[3];
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      seen[axis] = point[axis] - origin[axis];
      size += std::abs(seen[axis]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      directions.Corner[corner][axis] = size > 0.0 ? static_cast<float>(seen[axis] / size) : 0.0f;
    }
  }
  return directions;
}

void SetTriangle(std::int32_t triangle, lms3dBeamPacket& packet)
{
  std::fill_n(packet.Range, lms3dBeamPacket::Size, lms3dBeamPacket::NoRange);
  std::fill_n(packet.Triangle, lms3dBeamPacket::Size, triangle);
}
} // namespace

/// A square part of the grid, cut off at the grid's end.
struct lms3dTileSearch::Area
{
  int Level;
  int Turn;
  int Beam;

  int GetSide() const { return BlockSide >> (2 * this->Level); }

  Area GetPart(int i) const
  {
    const int side = this->GetSide() / 4;
    return { this->Level + 1, this->Turn + i / 4 * side, this->Beam + i % 4 * side };
  }
};

/// The packets of a tile in the packets of a band.
struct lms3dTileSearch::PacketsOfTile
{
  lms3dTileSearch::Area Area;
  lms3dBeamPacket* First;
  int Stride;
  int Rows;
  int Columns;

  // Calls `function` with the number of the part that a packet is, and the packet.
  template <typename Function>
  void ForEach(const Function& function) const
  {
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        function(4 * row + column, this->First[row * this->Stride + column]);
      }
    }
  }
};

/// The candidates of sixteen tiles.
class lms3dTileSearch::Parts
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

  // Whether all beams of a tile have the triangle of GetTriangle.
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

bool lms3dTileSearch::IsSuitable(const lms3dBeamGrid& grid, std::size_t triangles)
{
  return triangles <= MaximumTriangles && triangles <= CountPackets(grid) &&
    grid.TurnStep * BlockSide <= MaximumBlockAngle;
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
  , BlocksPerTurn(CountBlocks(grid.Beams))
  , NumberOfBlocks(CountBlocks(grid.Turns) * this->BlocksPerTurn)
  , Corners(view.GetMesh().GetNumberOfTriangles())
{
  for (int level = 0; level < 3; ++level)
  {
    const double angle = 0.5 * ((BlockSide >> (2 * level)) - 1) * grid.TurnStep;
    this->HalfCosines[level] =
      static_cast<float>(std::cos(angle * (std::acos(-1.0) / 180.0)) * CosineMargin);
  }
}

bool lms3dTileSearch::Divide()
{
  tbb::parallel_for(std::size_t(0), this->Corners.size(),
    [this](std::size_t i)
    {
      this->Corners[i] =
        GetCornerDirections(this->View.GetMesh(), i, this->View.GetOrigin().Position);
    });
  const std::vector<lms3dTileCandidates> candidates = this->DivideGrid();
  std::size_t total = 0;
  for (const lms3dTileCandidates& ofBlock : candidates)
  {
    total += ofBlock.size();
  }
  if (static_cast<double>(total) >
    MaximumCandidatesPerPacket * static_cast<double>(CountPackets(this->Grid)))
  {
    return false;
  }
  this->Blocks.resize(candidates.size());
  tbb::parallel_for(0, this->NumberOfBlocks,
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
  std::vector<lms3dTileCandidates> candidates(this->NumberOfBlocks);
  const int groups = (this->NumberOfBlocks - 1) / lms3dTiles::Size + 1;
  tbb::parallel_for(0, groups,
    [&](int group)
    {
      const int first = group * lms3dTiles::Size;
      const int count = std::min(lms3dTiles::Size, this->NumberOfBlocks - first);
      lms3dTiles tiles;
      for (int i = 0; i < lms3dTiles::Size; ++i)
      {
        this->FillTile(this->GetBlockArea(std::min(first + i, this->NumberOfBlocks - 1)), i, tiles);
      }
      Parts parts;
      this->Divide(all.data(), all.size(), (1u << count) - 1u, tiles, parts);
      for (int i = 0; i < count; ++i)
      {
        candidates[first + i] = std::move(parts.Candidates[i]);
      }
    });
  return candidates;
}

lms3dTileSearch::Block lms3dTileSearch::DivideBlock(
  int number, const lms3dTileCandidates& candidates) const
{
  lms3dTiles tiles;
  const std::uint32_t present = this->FillTiles(this->GetBlockArea(number), tiles);
  Parts parts;
  this->Divide(candidates.data(), candidates.size(), present, tiles, parts);
  Block block = { {}, {}, 0 };
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    const lms3dTileCandidates& ofTile = parts.Candidates[i];
    block.Decided |= parts.IsDecided(i) ? 1u << i : 0u;
    block.Candidates.insert(block.Candidates.end(), ofTile.begin(), ofTile.end());
    block.First[i + 1] = static_cast<std::uint32_t>(block.Candidates.size());
  }
  return block;
}

lms3dTileSearch::Area lms3dTileSearch::GetBlockArea(int block) const
{
  return { 0, block / this->BlocksPerTurn * BlockSide, block % this->BlocksPerTurn * BlockSide };
}

void lms3dTileSearch::FillTile(const Area& area, int i, lms3dTiles& tiles) const
{
  const int lastTurn = this->Grid.Turns - 1;
  const int lastBeam = this->Grid.Beams - 1;
  const int turns[2] = { std::min(area.Turn, lastTurn),
    std::min(area.Turn + area.GetSide() - 1, lastTurn) };
  const int beams[2] = { std::min(area.Beam, lastBeam),
    std::min(area.Beam + area.GetSide() - 1, lastBeam) };
  for (int end = 0; end < 2; ++end)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      tiles.Fan[end][axis][i] = static_cast<float>(this->Grid.FanAxes[turns[end]][axis]);
    }
    tiles.Cosine[end][i] = static_cast<float>(this->Grid.Cosines[beams[end]]);
    const float sine = static_cast<float>(this->Grid.Sines[beams[end]]);
    const bool isTowardsHorizon = end == 0 ? sine > 0.0f : sine < 0.0f;
    tiles.Sine[end][i] = isTowardsHorizon ? sine * this->HalfCosines[area.Level] : sine;
  }
}

// Returns the parts that the grid has.
std::uint32_t lms3dTileSearch::FillTiles(const Area& whole, lms3dTiles& tiles) const
{
  std::uint32_t present = 0;
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    const Area part = whole.GetPart(i);
    this->FillTile(part, i, tiles);
    const bool isPresent = part.Turn < this->Grid.Turns && part.Beam < this->Grid.Beams;
    present |= isPresent ? 1u << i : 0u;
  }
  return present;
}

void lms3dTileSearch::Divide(const lms3dTileCandidate* candidates, std::size_t count,
  std::uint32_t present, lms3dTiles& tiles, Parts& parts) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    tiles.Up[axis] = static_cast<float>(this->Grid.Up[axis]);
  }
  this->Kernels.FillTileCorners(tiles);
  parts.Clear();
  lms3dTileCover cover = {};
  for (std::size_t i = 0; i < count; ++i)
  {
    const lms3dTileCandidate& candidate = candidates[i];
    const lms3dTileMasks masks = this->Kernels.ClassifyTiles(tiles,
      this->View.GetNarrowTriangle(candidate.Triangle), this->Corners[candidate.Triangle],
      { present, candidate.Covers ? present : 0u, 0u }, this->View.GetMinimumInverse(), cover);
    parts.Add(candidate.Triangle, masks);
  }
}

void lms3dTileSearch::FindNearest(
  int firstTurn, lms3dBeamPacket* packets, int count, const CastPacket& castPacket) const
{
  const int columns = lms3dBeamGrid::CountPackets(this->Grid.Beams);
  const int firstBlock = firstTurn / BlockSide * this->BlocksPerTurn;
  const int firstPart = firstTurn % BlockSide / TileSide * 4;
  Parts parts;
  for (int column = 0; column < columns; column += 4)
  {
    const int beam = column * lms3dBeamGrid::Side;
    const Block& block = this->Blocks[firstBlock + beam / BlockSide];
    const int part = firstPart + beam % BlockSide / TileSide;
    const PacketsOfTile tile = { { 1, firstTurn, beam }, packets + column, columns, count / columns,
      std::min(4, columns - column) };
    this->FindInTile(block, part, tile, parts, castPacket);
  }
}

void lms3dTileSearch::FindInTile(const Block& block, int part, const PacketsOfTile& tile,
  Parts& parts, const CastPacket& castPacket) const
{
  const lms3dTileCandidate* candidates = block.Candidates.data() + block.First[part];
  const std::size_t count = block.First[part + 1] - block.First[part];
  if ((block.Decided >> part) & 1u)
  {
    const std::int32_t triangle = count == 0 ? lms3dBeamPacket::NoTriangle : candidates[0].Triangle;
    tile.ForEach([triangle](int, lms3dBeamPacket& packet) { SetTriangle(triangle, packet); });
    return;
  }
  if (count > MaximumCandidatesOfTile)
  {
    tile.ForEach([&castPacket](int, lms3dBeamPacket& packet) { castPacket(packet); });
    return;
  }
  lms3dTiles tiles;
  const std::uint32_t present = this->FillTiles(tile.Area, tiles);
  this->Divide(candidates, count, present, tiles, parts);
  tile.ForEach(
    [&](int i, lms3dBeamPacket& packet)
    {
      if (parts.IsDecided(i))
      {
        SetTriangle(parts.GetTriangle(i), packet);
      }
      else if (parts.Candidates[i].size() > MaximumCandidatesOfPacket)
      {
        castPacket(packet);
      }
      else
      {
        this->TestCandidates(parts.Candidates[i], packet);
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
