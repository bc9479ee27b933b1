// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dGuessedBlocks.h"

#include "Fusion/Cells/lms3dRasterRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Size = lms3dRaster::Size;
constexpr std::int32_t Least = std::numeric_limits<std::int32_t>::min();
// Cells: no block lies farther away.
constexpr double LargestCell = 2e9;

bool IsInRange(const lms3dCutPolygon& polygon)
{
  return std::all_of(polygon.begin(), polygon.end(),
    [](const lms3dPoint2& corner)
    { return std::abs(corner[0]) <= LargestCell && std::abs(corner[1]) <= LargestCell; });
}
} // namespace

lms3dGuessedBlocks::lms3dGuessedBlocks(const lms3dRaster& raster)
{
  for (const int number : raster.GetMarked())
  {
    if (raster.HasMark(number, lms3dRaster::GUESSED))
    {
      const lms3dRasterBlock& block = raster.GetBlock(number);
      this->Blocks.push_back({ block.V, block.U, number });
    }
  }
  std::sort(this->Blocks.begin(), this->Blocks.end());
}

std::vector<lms3dGuessedBlocks::Block>::const_iterator lms3dGuessedBlocks::Find(
  std::int32_t v, std::int32_t u) const
{
  return std::lower_bound(this->Blocks.begin(), this->Blocks.end(), Block{ v, u, 0 });
}

template <typename Visitor>
bool lms3dGuessedBlocks::ForStrips(const lms3dCutPolygon& polygon, const Visitor& visit) const
{
  if (!IsInRange(polygon))
  {
    return true;
  }
  const auto [low, high] = lms3dGetHeights(polygon);
  const std::int32_t first = lms3dGetCellFrom(low - 0.5);
  const std::int32_t last = lms3dGetCellOf(high - 0.5);
  for (auto row = this->Find(lms3dRaster::GetBlockOf(first), Least);
       row != this->Blocks.end() && row->V <= lms3dRaster::GetBlockOf(last);
       row = this->Find(row->V + 1, Least))
  {
    const std::int32_t bottom = row->V * Size;
    const lms3dCellStrip strip =
      lms3dGetCentreStrip(polygon, std::max(first, bottom), std::min(last, bottom + Size - 1));
    if (strip.IsEmpty())
    {
      continue;
    }
    const std::int32_t right = lms3dRaster::GetBlockOf(strip.Right);
    for (auto block = this->Find(row->V, lms3dRaster::GetBlockOf(strip.Left));
         block != this->Blocks.end() && block->V == row->V && block->U <= right; ++block)
    {
      if (!visit(block->Number, strip))
      {
        return false;
      }
    }
  }
  return true;
}

bool lms3dGuessedBlocks::HasAny(const lms3dCutPolygon& polygon, const lms3dRaster& raster) const
{
  return !this->ForStrips(polygon,
    [&](int number, const lms3dCellStrip& strip)
    {
      const lms3dRasterBlock& block = raster.GetBlock(number);
      const std::uint64_t* const guess = &block.Guess[lms3dRaster::GetPlaceOf(strip.Row)];
      std::uint64_t found = 0;
      for (int row = 0; row < strip.Count; ++row)
      {
        found |= guess[row] & strip.GetBits(row, block.U * Size);
      }
      return found == 0;
    });
}

void lms3dGuessedBlocks::Clear(const lms3dCutPolygon& polygon, lms3dRaster& raster) const
{
  this->ForStrips(polygon,
    [&](int number, const lms3dCellStrip& strip)
    {
      lms3dRasterBlock& block = raster.GetBlock(number);
      std::uint64_t* const guess = &block.Guess[lms3dRaster::GetPlaceOf(strip.Row)];
      for (int row = 0; row < strip.Count; ++row)
      {
        guess[row] &= ~strip.GetBits(row, block.U * Size);
      }
      return true;
    });
}
