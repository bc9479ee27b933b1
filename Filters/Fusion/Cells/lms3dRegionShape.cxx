// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dRegionShape.h"

#include "Fusion/Cells/lms3dRegionRaster.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <utility>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// Counts cells that differ between Shape and Meshed. `crease` may be nullptr.
void CountDifferences(const lms3dCreaseMask::Cells* crease, lms3dRasterBlock& block)
{
  std::size_t count = 0;
  std::size_t near = 0;
  for (int row = 0; row <= Last; ++row)
  {
    const std::uint64_t different = block.Shape[row] ^ block.Meshed[row];
    count += std::bitset<lms3dRaster::Size>(different).count();
    near += std::bitset<lms3dRaster::Size>(crease ? different & crease->Near[row] : 0).count();
  }
  block.Difference = static_cast<int>(count);
  block.DifferenceAtCreases = static_cast<int>(near);
}

// The cells that are not in a mask.
lms3dBits Without(lms3dBits cells, const lms3dBits& mask)
{
  for (int row = 0; row <= Last; ++row)
  {
    cells[row] &= ~mask[row];
  }
  return cells;
}
} // namespace

lms3dBits lms3dRegionShape::GetFree(int number, const lms3dRegionCells& cells) const
{
  const lms3dCreaseMask::Cells* const crease = this->Creases.Get(number);
  return crease ? Without(cells.May, crease->Line) : cells.May;
}

// Returns near a crease may be of the other plane.
lms3dBits lms3dRegionShape::GetReturns(int number, const lms3dRasterBlock& block) const
{
  const lms3dCreaseMask::Cells* const crease = this->Creases.Get(number);
  return crease ? Without(block.Must, crease->Near) : block.Must;
}

lms3dRegionShape::Round lms3dRegionShape::MakeRound(
  std::vector<int> blocks, const lms3dRaster& raster)
{
  std::vector<lms3dRegionCells> cells;
  cells.reserve(blocks.size());
  for (const int number : blocks)
  {
    cells.push_back(lms3dMakeRegionCells(raster, number));
  }
  std::vector<lms3dBlockParts> parts;
  parts.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    parts.emplace_back(this->GetFree(blocks[i], cells[i]));
    this->Reached.Set(
      blocks[i], parts.back(), this->GetReturns(blocks[i], raster.GetBlock(blocks[i])));
  }
  return { std::move(blocks), std::move(cells), std::move(parts) };
}

lms3dBits lms3dRegionShape::GetShape(
  int number, const lms3dBlockParts& parts, const lms3dRegionCells& cells) const
{
  lms3dBits shape = cells.Must;
  parts.ForRuns([&](int part, int row, std::uint64_t bits)
    { shape[row] |= this->Reached.IsReached(number, part) ? bits : 0; });
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
  const lms3dRegionCells& cells, lms3dRaster& raster, std::vector<int>& changed) const
{
  lms3dRasterBlock& block = raster.GetBlock(number);
  block.IsCalm = this->Reached.HaveReturns(number);
  block.Region = cells.Squares;
  const lms3dBits shape = this->GetShape(number, parts, cells);
  if (shape != block.Shape || block.NewCreaseCells > 0)
  {
    block.Shape = shape;
    block.IsShapeFull = lms3dAreAllSet(shape);
    CountDifferences(this->Creases.Get(number), block);
    changed.push_back(number);
  }
}

std::vector<int> lms3dRegionShape::Update(
  const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster)
{
  this->Reached.AddBlocks(raster);
  this->Creases.Draw(creases, raster);
  std::vector<Round> rounds;
  std::vector<int> all;
  lms3dMarkDependents(raster);
  std::vector<int> blocks;
  for (const int number : raster.GetMarked())
  {
    if (raster.HasMark(number, lms3dRaster::DIRTY))
    {
      blocks.push_back(number);
    }
  }
  std::sort(blocks.begin(), blocks.end());
  while (!blocks.empty())
  {
    all.insert(all.end(), blocks.begin(), blocks.end());
    std::sort(all.begin(), all.end());
    rounds.push_back(this->MakeRound(std::move(blocks), raster));
    blocks = this->Reached.Update();
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                   [&](int number) { return std::binary_search(all.begin(), all.end(), number); }),
      blocks.end());
  }
  std::vector<int> changed;
  for (const Round& round : rounds)
  {
    for (std::size_t i = 0; i < round.Blocks.size(); ++i)
    {
      this->MakeShape(round.Blocks[i], round.Parts[i], round.Cells[i], raster, changed);
    }
  }
  std::sort(changed.begin(), changed.end());
  return changed;
}
