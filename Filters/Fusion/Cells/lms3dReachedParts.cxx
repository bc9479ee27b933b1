// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dReachedParts.h"

#include <algorithm>
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
} // namespace

void lms3dReachedParts::AddBlocks(const lms3dRaster& raster)
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

void lms3dReachedParts::Set(int number, const lms3dBlockParts& parts, const lms3dBits& returns)
{
  std::vector<Part> made(static_cast<std::size_t>(parts.GetCount()), { {}, false, false });
  parts.ForRuns(
    [&](int i, int row, std::uint64_t bits)
    {
      Part& part = made[i];
      part.HasReturn = part.HasReturn || (bits & returns[row]) != 0;
      part.Cells[0] |= (bits & 1U) << row;
      part.Cells[1] |= (bits >> Last) << row;
      part.Cells[2] |= row == 0 ? bits : 0;
      part.Cells[3] |= row == Last ? bits : 0;
    });
  std::vector<Part>& kept = this->Blocks[number].Parts;
  const bool isSame = std::equal(kept.begin(), kept.end(), made.begin(), made.end(),
    [](const Part& a, const Part& b) { return a.Cells == b.Cells && a.HasReturn == b.HasReturn; });
  if (!isSame)
  {
    kept = std::move(made);
    this->HasChanged = true;
  }
}

bool lms3dReachedParts::HaveReturns(int number) const
{
  const std::vector<Part>& parts = this->Blocks[number].Parts;
  return std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.HasReturn; });
}

void lms3dReachedParts::Connect(std::vector<int>& links) const
{
  for (const Block& block : this->Blocks)
  {
    for (const auto& [number, side, opposite] :
      { std::array<int, 3>{ block.Right, 1, 0 }, std::array<int, 3>{ block.Above, 3, 2 } })
    {
      if (number < 0)
      {
        continue;
      }
      const Block& other = this->Blocks[number];
      for (std::size_t a = 0; a < block.Parts.size(); ++a)
      {
        for (std::size_t b = 0; b < other.Parts.size(); ++b)
        {
          if ((block.Parts[a].Cells[side] & other.Parts[b].Cells[opposite]) != 0)
          {
            const int first = FindFirst(links, block.FirstPart + static_cast<int>(a));
            links[first] = FindFirst(links, other.FirstPart + static_cast<int>(b));
          }
        }
      }
    }
  }
}

template <typename Visitor>
void lms3dReachedParts::ForParts(const Visitor& visit)
{
  for (std::size_t number = 0; number < this->Blocks.size(); ++number)
  {
    int part = this->Blocks[number].FirstPart;
    for (Part& cells : this->Blocks[number].Parts)
    {
      visit(static_cast<int>(number), part++, cells);
    }
  }
}

std::vector<int> lms3dReachedParts::Update()
{
  std::vector<int> changed;
  if (!std::exchange(this->HasChanged, false))
  {
    return changed;
  }
  int count = 0;
  for (Block& block : this->Blocks)
  {
    block.FirstPart = count;
    count += static_cast<int>(block.Parts.size());
  }
  std::vector<int> links(static_cast<std::size_t>(count));
  std::iota(links.begin(), links.end(), 0);
  this->Connect(links);
  std::vector<bool> isReached(links.size());
  this->ForParts(
    [&](int, int part, const Part& cells)
    {
      const int first = FindFirst(links, part);
      isReached[first] = isReached[first] || cells.HasReturn;
    });
  this->ForParts(
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
