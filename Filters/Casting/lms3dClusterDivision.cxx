// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dClusterDivision.h"

#include "Casting/lms3dBitMask.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace
{
// Measured: a cluster is replaced by its parts within this number of its radii.
constexpr float NearDistance = 4.0f;

// Margins of the boxes cover the rounding of the position and of these four operations.
lms3dTileBox MakeTileBox(const lms3dNormalizedBox& box, const float (&position)[3])
{
  lms3dTileBox result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.Center[axis] = 0.5f * (box.Low[axis] + box.High[axis]) - position[axis];
    result.HalfSize[axis] = 0.5f * (box.High[axis] - box.Low[axis]);
  }
  return result;
}

bool IsNear(const lms3dTileBox& box)
{
  float distance = 0.0f;
  float size = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    distance += box.Center[axis] * box.Center[axis];
    size += box.HalfSize[axis] * box.HalfSize[axis];
  }
  return distance < NearDistance * NearDistance * size;
}
} // namespace

lms3dClusterDivision::lms3dClusterDivision(const lms3dTriangleClusters& clusters,
  const lms3dNormalization& normalization, const double origin[3], const lms3dTileGrid& grid)
  : All(clusters)
  , Grid(grid)
{
  float position[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] = static_cast<float>(normalization.NormalizeCoordinate(origin, axis));
  }
  const auto add = [&](const lms3dTriangleClusters::Group& group) {
    this->Chosen.push_back({ MakeTileBox(group.Box, position), group.First, group.Count });
  };
  for (std::size_t i = 0; i < clusters.GetCount(); ++i)
  {
    add(clusters.GetCluster(i));
    if (IsNear(this->Chosen.back().Box))
    {
      this->Chosen.pop_back();
      clusters.ForEachPart(i, add);
    }
  }
}

std::vector<lms3dTileBlock> lms3dClusterDivision::Divide(std::size_t maximum) const
{
  const std::vector<Groups> groups = this->DivideGrid();
  std::vector<lms3dTileBlock> blocks(groups.size());
  tbb::parallel_for(0, this->Grid.GetNumberOfBlocks(),
    [&](int block) { blocks[block] = this->DivideBlock(block, groups[block], maximum); });
  return blocks;
}

std::vector<lms3dClusterDivision::Groups> lms3dClusterDivision::DivideGrid() const
{
  std::vector<Groups> result(this->Grid.GetNumberOfBlocks());
  tbb::parallel_for(0, this->Grid.CountGroups(),
    [&](int group)
    {
      lms3dTiles tiles;
      const std::uint32_t present = this->Grid.FillGroup(group, tiles);
      Groups* const first = result.data() + static_cast<std::ptrdiff_t>(group) * lms3dTiles::Size;
      for (std::size_t i = 0; i < this->Chosen.size(); ++i)
      {
        std::uint32_t met = present & this->Kernels.FindTilesOfBox(tiles, this->Chosen[i].Box);
        for (; met != 0; met &= met - 1)
        {
          first[lms3dGetFirstBit(met)].push_back(static_cast<std::uint32_t>(i));
        }
      }
    });
  return result;
}

lms3dTileBlock lms3dClusterDivision::DivideBlock(
  int number, const Groups& groups, std::size_t maximum) const
{
  lms3dTiles tiles;
  const std::uint32_t present = this->Grid.FillParts(this->Grid.GetBlock(number), tiles);
  std::array<Groups, lms3dTiles::Size> ofTiles;
  for (std::uint32_t group : groups)
  {
    std::uint32_t met = present & this->Kernels.FindTilesOfBox(tiles, this->Chosen[group].Box);
    for (; met != 0; met &= met - 1)
    {
      ofTiles[lms3dGetFirstBit(met)].push_back(group);
    }
  }
  lms3dTileBlock block;
  for (int tile = 0; tile < lms3dTiles::Size; ++tile)
  {
    if (ofTiles[tile].empty())
    {
      block.Decided |= 1u << tile;
    }
    else if (this->CountTriangles(ofTiles[tile]) > maximum)
    {
      block.Crowded |= 1u << tile;
    }
    else
    {
      this->AppendTriangles(ofTiles[tile], block);
    }
    block.EndTile(tile);
  }
  return block;
}

std::size_t lms3dClusterDivision::CountTriangles(const Groups& groups) const
{
  std::size_t count = 0;
  for (std::uint32_t group : groups)
  {
    count += this->Chosen[group].Count;
  }
  return count;
}

void lms3dClusterDivision::AppendTriangles(const Groups& groups, lms3dTileBlock& block) const
{
  for (std::uint32_t group : groups)
  {
    const std::uint32_t* const first = this->All.GetTriangles() + this->Chosen[group].First;
    std::transform(first, first + this->Chosen[group].Count, std::back_inserter(block.Candidates),
      [](std::uint32_t triangle) {
        return lms3dTileCandidate{ static_cast<std::int32_t>(triangle), false };
      });
  }
}
