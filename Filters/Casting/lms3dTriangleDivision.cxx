// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTriangleDivision.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

namespace
{
// Few enough to share the work among threads.
constexpr std::size_t TrianglesOfPart = 64;
} // namespace

lms3dTriangleDivision::lms3dTriangleDivision(
  lms3dExactView& view, lms3dTileClassifier& classifier, const lms3dTileGrid& grid)
  : Classifier(classifier)
  , Grid(grid)
{
  view.AllocateNarrowTriangles();
  classifier.AllocateCorners();
  std::vector<lms3dTiles> groups(grid.CountGroups());
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    grid.FillGroup(static_cast<int>(group), groups[group]);
  }
  const std::size_t triangles = view.GetMesh().GetNumberOfTriangles();
  this->Parts.resize((triangles - 1) / TrianglesOfPart + 1);
  tbb::parallel_for(std::size_t(0), this->Parts.size(),
    [&](std::size_t part)
    {
      const std::size_t begin = part * TrianglesOfPart;
      const std::size_t end = std::min(begin + TrianglesOfPart, triangles);
      view.MakeNarrowTriangles(begin, end);
      classifier.MakeCorners(begin, end);
      this->Parts[part] = this->DividePart(begin, end, groups);
    });
}

lms3dTriangleDivision::Part lms3dTriangleDivision::DividePart(
  std::size_t begin, std::size_t end, const std::vector<lms3dTiles>& groups) const
{
  lms3dTileCandidates triangles(end - begin);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    triangles[i] = { static_cast<std::int32_t>(begin + i), false };
  }
  Part part;
  part.reserve(groups.size());
  for (const lms3dTiles& tiles : groups)
  {
    const std::uint32_t present = this->Grid.GetBlocksOfGroup(static_cast<int>(part.size()));
    part.emplace_back(
      this->Classifier.Classify(triangles.data(), triangles.size(), present, tiles, nullptr));
  }
  return part;
}

std::size_t lms3dTriangleDivision::CountCandidates() const
{
  std::size_t count = 0;
  for (const Part& part : this->Parts)
  {
    for (const lms3dTileBlock& group : part)
    {
      count += group.Candidates.size();
    }
  }
  return count;
}

std::vector<lms3dTileBlock> lms3dTriangleDivision::Divide() const
{
  std::vector<lms3dTileBlock> blocks(this->Grid.GetNumberOfBlocks());
  tbb::parallel_for(0, this->Grid.GetNumberOfBlocks(),
    [&](int block) { blocks[block] = this->DivideBlock(block); });
  return blocks;
}

lms3dTileBlock lms3dTriangleDivision::DivideBlock(int number) const
{
  const int group = number / lms3dTiles::Size;
  const int i = number % lms3dTiles::Size;
  std::size_t count = 0;
  for (const Part& part : this->Parts)
  {
    count += part[group].First[i + 1] - part[group].First[i];
  }
  lms3dTileCandidates candidates;
  candidates.reserve(count);
  // What covers the block comes first, since it drops at once what lies behind it.
  for (bool covers : { true, false })
  {
    for (const Part& part : this->Parts)
    {
      const lms3dTileBlock& blocks = part[group];
      std::copy_if(blocks.Candidates.begin() + blocks.First[i],
        blocks.Candidates.begin() + blocks.First[i + 1], std::back_inserter(candidates),
        [covers](const lms3dTileCandidate& candidate) { return candidate.Covers == covers; });
    }
  }
  lms3dTiles tiles;
  const std::uint32_t present = this->Grid.FillParts(this->Grid.GetBlock(number), tiles);
  return lms3dTileBlock(
    this->Classifier.Classify(candidates.data(), candidates.size(), present, tiles, nullptr));
}
