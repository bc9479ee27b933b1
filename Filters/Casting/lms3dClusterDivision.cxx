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

// Few enough to share the work among threads.
constexpr std::size_t ClustersOfPart = 64;

constexpr std::size_t GroupsOfWord = 32;

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
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Position[axis] = static_cast<float>(normalization.NormalizeCoordinate(origin, axis));
  }
  std::vector<lms3dTiles> blocks(grid.CountGroups());
  for (std::size_t group = 0; group < blocks.size(); ++group)
  {
    grid.FillGroup(static_cast<int>(group), blocks[group]);
  }
  this->Parts.resize((clusters.GetCount() + ClustersOfPart - 1) / ClustersOfPart);
  tbb::parallel_for(std::size_t(0), this->Parts.size(),
    [&](std::size_t part)
    {
      const std::size_t begin = part * ClustersOfPart;
      const std::size_t end = std::min(begin + ClustersOfPart, clusters.GetCount());
      this->Parts[part] = this->DividePart(begin, end, blocks);
    });
}

std::vector<lms3dClusterDivision::Group> lms3dClusterDivision::Choose(
  std::size_t begin, std::size_t end) const
{
  std::vector<Group> chosen;
  const auto add = [&](const lms3dTriangleClusters::Group& group) {
    chosen.push_back({ MakeTileBox(group.Box, this->Position), group.First, group.Count });
  };
  for (std::size_t i = begin; i < end; ++i)
  {
    add(this->All.GetCluster(i));
    if (IsNear(chosen.back().Box))
    {
      chosen.pop_back();
      this->All.ForEachPart(i, add);
    }
  }
  return chosen;
}

lms3dClusterDivision::Part lms3dClusterDivision::DividePart(
  std::size_t begin, std::size_t end, const std::vector<lms3dTiles>& blocks) const
{
  Part part;
  part.Chosen = this->Choose(begin, end);
  const std::size_t stride = blocks.size() * lms3dTiles::Size;
  part.Met.resize((part.Chosen.size() + GroupsOfWord - 1) / GroupsOfWord * stride);
  for (std::size_t i = 0; i < part.Chosen.size(); ++i)
  {
    std::uint32_t* const ofBlocks = part.Met.data() + i / GroupsOfWord * stride;
    for (std::size_t group = 0; group < blocks.size(); ++group)
    {
      std::uint32_t met = this->Grid.GetBlocksOfGroup(static_cast<int>(group)) &
        this->Kernels.FindTilesOfBox(blocks[group], part.Chosen[i].Box);
      for (; met != 0; met &= met - 1)
      {
        ofBlocks[group * lms3dTiles::Size + lms3dGetFirstBit(met)] |= 1u << i % GroupsOfWord;
      }
    }
  }
  return part;
}

std::vector<lms3dTileBlock> lms3dClusterDivision::Divide(std::size_t maximum) const
{
  std::vector<lms3dTileBlock> blocks(this->Grid.GetNumberOfBlocks());
  tbb::parallel_for(0, this->Grid.GetNumberOfBlocks(),
    [&](int block) { blocks[block] = this->DivideBlock(block, maximum); });
  return blocks;
}

lms3dTileBlock lms3dClusterDivision::DivideBlock(int number, std::size_t maximum) const
{
  lms3dTiles tiles;
  const std::uint32_t present = this->Grid.FillParts(this->Grid.GetBlock(number), tiles);
  const std::size_t stride = static_cast<std::size_t>(this->Grid.CountGroups()) * lms3dTiles::Size;
  ContentsOfBlock contents{ {}, 0, maximum };
  for (const Part& part : this->Parts)
  {
    for (std::size_t first = 0; first < part.Chosen.size(); first += GroupsOfWord)
    {
      std::uint32_t met = part.Met[first / GroupsOfWord * stride + number];
      for (; met != 0; met &= met - 1)
      {
        this->AddGroup(part.Chosen[first + lms3dGetFirstBit(met)], present, tiles, contents);
      }
    }
  }
  lms3dTileBlock block;
  block.Crowded = contents.Crowded;
  for (int tile = 0; tile < lms3dTiles::Size; ++tile)
  {
    if (contents.OfTiles[tile].Count == 0)
    {
      block.Decided |= 1u << tile;
    }
    else if (!lms3dHasBit(contents.Crowded, tile))
    {
      this->AppendTriangles(contents.OfTiles[tile], block);
    }
    block.EndTile(tile);
  }
  return block;
}

void lms3dClusterDivision::AddGroup(const Group& group, std::uint32_t present,
  const lms3dTiles& tiles, ContentsOfBlock& contents) const
{
  const std::uint32_t met = present & this->Kernels.FindTilesOfBox(tiles, group.Box);
  const std::uint32_t open = met & ~contents.Crowded;
  if (group.Count <= MaximumOfDivided && lms3dCountBits(met) >= MinimumTilesOfDivided)
  {
    this->AddTriangles(group, open, tiles, contents);
  }
  else
  {
    for (std::uint32_t rest = open; rest != 0; rest &= rest - 1)
    {
      Contents& ofTile = contents.OfTiles[lms3dGetFirstBit(rest)];
      ofTile.Whole.push_back(&group);
      ofTile.Count += group.Count;
    }
  }
  for (std::uint32_t rest = open; rest != 0; rest &= rest - 1)
  {
    const int tile = lms3dGetFirstBit(rest);
    contents.Crowded |= contents.OfTiles[tile].Count > contents.Maximum ? 1u << tile : 0u;
  }
}

// Adds the triangles of a group whose box says little.
void lms3dClusterDivision::AddTriangles(
  const Group& group, std::uint32_t met, const lms3dTiles& tiles, ContentsOfBlock& contents) const
{
  if (met == 0)
  {
    return;
  }
  lms3dNarrowCache* const kept = this->Classifier.GetView().GetKept();
  for (std::uint32_t i = group.First; i < group.First + group.Count; ++i)
  {
    const std::uint32_t triangle = this->All.GetTriangles()[i];
    std::uint32_t rest =
      this->Classifier.FindMet(static_cast<std::int32_t>(triangle), met, tiles, kept);
    for (; rest != 0; rest &= rest - 1)
    {
      Contents& ofTile = contents.OfTiles[lms3dGetFirstBit(rest)];
      ofTile.Triangles.push_back(triangle);
      ++ofTile.Count;
    }
  }
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
  for (const Group* group : contents.Whole)
  {
    append(this->All.GetTriangles() + group->First, group->Count);
  }
}
