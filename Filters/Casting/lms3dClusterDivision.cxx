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

// A group of few triangles that can meet this many tiles of a block lies beside the sensor or
// around it.
constexpr std::uint32_t MaximumOfDivided = 16;
constexpr int MinimumTilesOfDivided = 8;

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
  const lms3dNormalization& normalization, const lms3dTileClassifier& classifier,
  const lms3dTileGrid& grid)
  : All(clusters)
  , Classifier(classifier)
  , Grid(grid)
{
  const double(&origin)[3] = classifier.GetView().GetOrigin().Position;
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
      this->Grid.FillGroup(group, tiles);
      const std::uint32_t present = this->Grid.GetBlocksOfGroup(group);
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
  std::array<Contents, lms3dTiles::Size> ofTiles;
  for (std::uint32_t groupNumber : groups)
  {
    const Group& group = this->Chosen[groupNumber];
    std::uint32_t met = present & this->Kernels.FindTilesOfBox(tiles, group.Box);
    if (group.Count <= MaximumOfDivided && lms3dCountBits(met) >= MinimumTilesOfDivided)
    {
      this->AddTriangles(group, met, tiles, ofTiles);
      continue;
    }
    for (; met != 0; met &= met - 1)
    {
      ofTiles[lms3dGetFirstBit(met)].Whole.push_back(groupNumber);
    }
  }
  lms3dTileBlock block;
  for (int tile = 0; tile < lms3dTiles::Size; ++tile)
  {
    const std::size_t count = this->CountTriangles(ofTiles[tile]);
    if (count == 0)
    {
      block.Decided |= 1u << tile;
    }
    else if (count > maximum)
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

// Adds the triangles of a group whose box says little.
void lms3dClusterDivision::AddTriangles(const Group& group, std::uint32_t met,
  const lms3dTiles& tiles, std::array<Contents, lms3dTiles::Size>& ofTiles) const
{
  lms3dNarrowCache* const kept = this->Classifier.GetView().GetKept();
  for (std::uint32_t i = group.First; i < group.First + group.Count; ++i)
  {
    const std::uint32_t triangle = this->All.GetTriangles()[i];
    std::uint32_t rest =
      this->Classifier.FindMet(static_cast<std::int32_t>(triangle), met, tiles, kept);
    for (; rest != 0; rest &= rest - 1)
    {
      ofTiles[lms3dGetFirstBit(rest)].Triangles.push_back(triangle);
    }
  }
}

std::size_t lms3dClusterDivision::CountTriangles(const Contents& contents) const
{
  std::size_t count = contents.Triangles.size();
  for (std::uint32_t group : contents.Whole)
  {
    count += this->Chosen[group].Count;
  }
  return count;
}

void lms3dClusterDivision::AppendTriangles(const Contents& contents, lms3dTileBlock& block) const
{
  const auto append = [&block](const std::uint32_t* first, std::size_t count)
  {
    std::transform(first, first + count, std::back_inserter(block.Candidates),
      [](std::uint32_t triangle) {
        return lms3dTileCandidate{ static_cast<std::int32_t>(triangle), false };
      });
  };
  append(contents.Triangles.data(), contents.Triangles.size());
  for (std::uint32_t group : contents.Whole)
  {
    append(this->All.GetTriangles() + this->Chosen[group].First, this->Chosen[group].Count);
  }
}
