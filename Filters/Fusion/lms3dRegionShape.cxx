// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionShape.h"

#include "Fusion/lms3dRegionRaster.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <numeric>
#include <utility>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

int FindFirst(std::vector<int>& links, int part)
{
  while (links[part] != part)
  {
    links[part] = links[links[part]];
    part = links[part];
  }
  return part;
}

int CountDifferences(const lms3dBits& a, const lms3dBits& b)
{
  std::size_t count = 0;
  for (int row = 0; row <= Last; ++row)
  {
    count += std::bitset<lms3dRaster::Size>(a[row] ^ b[row]).count();
  }
  return static_cast<int>(count);
}
} // namespace

// Links new blocks with their neighbours.
void lms3dRegionShape::AddBlocks(const lms3dRaster& raster)
{
  const auto before = static_cast<int>(this->Blocks.size());
  this->Blocks.resize(static_cast<std::size_t>(raster.GetNumberOfBlocks()));
  for (int number = before; number < raster.GetNumberOfBlocks(); ++number)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    this->Blocks[number].Right = raster.Find(block.U + 1, block.V);
    this->Blocks[number].Above = raster.Find(block.U, block.V + 1);
    const int left = raster.Find(block.U - 1, block.V);
    const int below = raster.Find(block.U, block.V - 1);
    if (left >= 0)
    {
      this->Blocks[left].Right = number;
    }
    if (below >= 0)
    {
      this->Blocks[below].Above = number;
    }
  }
}

lms3dBits lms3dRegionShape::GetFree(int number, const lms3dRegionBlock& cells) const
{
  lms3dBits free = cells.May;
  if (const lms3dCreaseMask::Cells* crease = this->Creases.Get(number))
  {
    for (int row = 0; row <= Last; ++row)
    {
      free[row] &= ~crease->Line[row];
    }
  }
  return free;
}

lms3dRegionShape::Round lms3dRegionShape::MakeRound(
  std::vector<int> blocks, const lms3dRaster& raster)
{
  lms3dRegion region = lms3dMakeRegion(raster, blocks);
  std::vector<lms3dBlockParts> parts = this->FindParts(blocks, region, raster);
  return { std::move(blocks), std::move(region), std::move(parts) };
}

std::vector<lms3dBlockParts> lms3dRegionShape::FindParts(
  const std::vector<int>& blocks, const lms3dRegion& region, const lms3dRaster& raster)
{
  std::vector<lms3dBlockParts> partsOfBlocks;
  partsOfBlocks.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const lms3dRegionBlock& cells = region.GetBlock(static_cast<int>(i));
    BlockState& state = this->Blocks[blocks[i]];
    const lms3dCreaseMask::Cells* const crease = this->Creases.Get(blocks[i]);
    const lms3dBits& must = raster.GetBlock(blocks[i]).Must;
    const lms3dBlockParts& parts = partsOfBlocks.emplace_back(this->GetFree(blocks[i], cells));
    state.Parts.assign(static_cast<std::size_t>(parts.GetCount()), { {}, false, false });
    parts.ForRuns(
      [&](int number, int row, std::uint64_t bits)
      {
        Part& part = state.Parts[number];
        const std::uint64_t near = crease ? crease->Near[row] : 0;
        part.HasReturn = part.HasReturn || (bits & must[row] & ~near) != 0;
        part.Cells[0] |= (bits & 1U) << row;
        part.Cells[1] |= (bits >> Last) << row;
        part.Cells[2] |= row == 0 ? bits : 0;
        part.Cells[3] |= row == Last ? bits : 0;
      });
  }
  return partsOfBlocks;
}

void lms3dRegionShape::Connect(std::vector<int>& links) const
{
  for (const BlockState& state : this->Blocks)
  {
    for (const auto& [number, side, opposite] :
      { std::array<int, 3>{ state.Right, 1, 0 }, std::array<int, 3>{ state.Above, 3, 2 } })
    {
      if (number < 0)
      {
        continue;
      }
      const BlockState& other = this->Blocks[number];
      for (std::size_t a = 0; a < state.Parts.size(); ++a)
      {
        for (std::size_t b = 0; b < other.Parts.size(); ++b)
        {
          if ((state.Parts[a].Cells[side] & other.Parts[b].Cells[opposite]) != 0)
          {
            const int first = FindFirst(links, state.FirstPart + static_cast<int>(a));
            links[first] = FindFirst(links, other.FirstPart + static_cast<int>(b));
          }
        }
      }
    }
  }
}

// Returns the blocks with parts that were reached before and are not any more, or the reverse.
std::vector<int> lms3dRegionShape::FindReached()
{
  int count = 0;
  for (BlockState& state : this->Blocks)
  {
    state.FirstPart = count;
    count += static_cast<int>(state.Parts.size());
  }
  std::vector<int> links(static_cast<std::size_t>(count));
  std::iota(links.begin(), links.end(), 0);
  this->Connect(links);
  std::vector<bool> isReached(links.size());
  const auto forParts = [this](const auto& visit)
  {
    for (std::size_t number = 0; number < this->Blocks.size(); ++number)
    {
      int part = this->Blocks[number].FirstPart;
      for (Part& cells : this->Blocks[number].Parts)
      {
        visit(static_cast<int>(number), part++, cells);
      }
    }
  };
  forParts(
    [&](int, int part, const Part& cells)
    {
      const int first = FindFirst(links, part);
      isReached[first] = isReached[first] || cells.HasReturn;
    });
  std::vector<int> changed;
  forParts(
    [&](int number, int part, Part& cells)
    {
      const bool isNow = isReached[FindFirst(links, part)];
      if (isNow != cells.IsReached && (changed.empty() || changed.back() != number))
      {
        changed.push_back(number);
      }
      cells.IsReached = isNow;
    });
  return changed;
}

lms3dBits lms3dRegionShape::GetShape(
  int number, const lms3dBlockParts& parts, const lms3dRegionBlock& cells) const
{
  const BlockState& state = this->Blocks[number];
  lms3dBits shape = cells.Must;
  parts.ForRuns([&](int part, int row, std::uint64_t bits)
    { shape[row] |= state.Parts[part].IsReached ? bits : 0; });
  const lms3dCreaseMask::Cells* const crease = this->Creases.Get(number);
  if (!crease)
  {
    return shape;
  }
  // Cells near a crease stay if they are joined to others that stay.
  lms3dBits near;
  for (int row = 0; row <= Last; ++row)
  {
    near[row] = cells.May[row] & crease->Near[row];
  }
  const lms3dBlockParts nearParts(near);
  std::vector<bool> stays(static_cast<std::size_t>(nearParts.GetCount()));
  nearParts.ForRuns([&](int part, int row, std::uint64_t bits)
    { stays[part] = stays[part] || (bits & shape[row]) != 0; });
  nearParts.ForRuns(
    [&](int part, int row, std::uint64_t bits) { shape[row] |= stays[part] ? bits : 0; });
  return shape;
}

void lms3dRegionShape::MakeShape(int number, const lms3dBlockParts& parts,
  const lms3dRegionBlock& cells, lms3dRaster& raster, std::vector<int>& changed) const
{
  lms3dRasterBlock& block = raster.GetBlock(number);
  const std::vector<Part>& states = this->Blocks[number].Parts;
  block.IsCalm =
    std::all_of(states.begin(), states.end(), [](const Part& part) { return part.HasReturn; });
  const lms3dBits shape = this->GetShape(number, parts, cells);
  if (shape != block.Shape || block.NewCreaseCells > 0)
  {
    block.Shape = shape;
    block.Difference = CountDifferences(shape, block.Meshed);
    changed.push_back(number);
  }
}

std::vector<int> lms3dRegionShape::Update(
  const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster)
{
  this->AddBlocks(raster);
  for (const lms3dCreaseLine& crease : creases)
  {
    this->Creases.Draw(crease, raster);
  }
  std::vector<Round> rounds;
  std::vector<int> all;
  std::vector<int> blocks = lms3dFindDirtyBlocks(raster);
  while (!blocks.empty())
  {
    all.insert(all.end(), blocks.begin(), blocks.end());
    std::sort(all.begin(), all.end());
    rounds.push_back(this->MakeRound(std::move(blocks), raster));
    blocks = this->FindReached();
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                   [&](int number) { return std::binary_search(all.begin(), all.end(), number); }),
      blocks.end());
  }
  std::vector<int> changed;
  for (const Round& round : rounds)
  {
    for (std::size_t i = 0; i < round.Blocks.size(); ++i)
    {
      this->MakeShape(round.Blocks[i], round.Parts[i], round.Region.GetBlock(static_cast<int>(i)),
        raster, changed);
    }
  }
  std::sort(changed.begin(), changed.end());
  return changed;
}
