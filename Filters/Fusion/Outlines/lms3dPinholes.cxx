// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dPinholes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace
{
// Cells: the most between a hole and the outside.
constexpr int LargestDepth = 4;
// Cells: larger islands stay.
constexpr std::size_t LargestIsland = 64;

using Cell = std::array<std::int32_t, 2>;
constexpr std::array<Cell, 4> Steps = { { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } } };

Cell Move(const Cell& cell, const Cell& step, int count)
{
  return { cell[0] + count * step[0], cell[1] + count * step[1] };
}

class Opener
{
public:
  Opener(const lms3dFusedTile& tile, lms3dRegion& region)
    : Tile(tile)
    , Region(region)
  {
  }

  void Open()
  {
    for (int number = 0; number < this->Region.GetNumberOfBlocks(); ++number)
    {
      for (int row = 0; row < lms3dRaster::Size; ++row)
      {
        this->LookAtRow(this->Region.GetBlock(number), row);
      }
    }
    // The outside is that of before, so the order of blocks does not matter.
    for (const Cell& cell : this->Opened)
    {
      this->Clear(cell);
    }
    for (const Cell& cell : this->Opened)
    {
      for (const Cell& step : Steps)
      {
        this->ClearIsland(Move(cell, step, 1));
      }
    }
  }

private:
  bool Has(lms3dRegion::BitsOf bits, const Cell& cell) const
  {
    return this->Region.Has(bits, cell[0], cell[1]);
  }

  void LookAtRow(const lms3dRegionBlock& block, int row)
  {
    for (std::uint64_t passed = block.Passed[row] & ~block.May[row] & GetBesideMay(block, row);
         passed != 0; passed &= passed - 1)
    {
      const int place = lms3dGetFirstBit(passed);
      this->LookAround({ block.U * lms3dRaster::Size + place, block.V * lms3dRaster::Size + row });
    }
  }

  /// The cells of a row that may have a neighbour with May.
  static std::uint64_t GetBesideMay(const lms3dRegionBlock& block, int row)
  {
    constexpr int Last = lms3dRaster::Size - 1;
    constexpr std::uint64_t AtSides = 1U | std::uint64_t{ 1 } << Last;
    if (row == 0 || row == Last)
    {
      return ~std::uint64_t{ 0 };
    }
    return AtSides | block.May[row] << 1U | block.May[row] >> 1U | block.May[row - 1] |
      block.May[row + 1];
  }

  void LookAround(const Cell& passed)
  {
    for (const Cell& step : Steps)
    {
      const int depth = this->GetDepth(passed, step);
      for (int i = 1; i <= depth; ++i)
      {
        this->Opened.push_back(Move(passed, step, i));
      }
    }
  }

  /// How many cells lie between a cell and the outside, 0 if they stay.
  int GetDepth(const Cell& from, const Cell& step) const
  {
    for (int i = 1; i <= LargestDepth + 1; ++i)
    {
      const Cell cell = Move(from, step, i);
      if (!this->Tile.Has({ cell[0] + 0.5, cell[1] + 0.5 }) ||
        this->Has(&lms3dRegionBlock::Must, cell))
      {
        return 0;
      }
      if (!this->Has(&lms3dRegionBlock::May, cell))
      {
        return i - 1;
      }
    }
    return 0;
  }

  void Clear(const Cell& cell)
  {
    const int number =
      this->Region.Find(lms3dRaster::GetBlockOf(cell[0]), lms3dRaster::GetBlockOf(cell[1]));
    this->Region.GetBlock(number).May[lms3dRaster::GetPlaceOf(cell[1])] &=
      ~(std::uint64_t{ 1 } << lms3dRaster::GetPlaceOf(cell[0]));
  }

  /// Clears the cells that are joined to one, if there are few and no return is among them.
  void ClearIsland(const Cell& first)
  {
    std::vector<Cell> island;
    if (this->Has(&lms3dRegionBlock::May, first) && this->Kept.count(first) == 0)
    {
      island.push_back(first);
    }
    for (std::size_t i = 0; i < island.size(); ++i)
    {
      const Cell cell = island[i];
      if (island.size() > LargestIsland || this->Has(&lms3dRegionBlock::Must, cell))
      {
        this->Kept.insert(island.begin(), island.end());
        return;
      }
      for (const Cell& step : Steps)
      {
        const Cell next = Move(cell, step, 1);
        if (this->Has(&lms3dRegionBlock::May, next) &&
          std::find(island.begin(), island.end(), next) == island.end())
        {
          island.push_back(next);
        }
      }
    }
    for (const Cell& cell : island)
    {
      this->Clear(cell);
    }
  }

  const lms3dFusedTile& Tile;
  lms3dRegion& Region;
  /// The cells that lose May.
  std::vector<Cell> Opened;
  /// Cells of islands that stay.
  std::set<Cell> Kept;
};
} // namespace

void lms3dOpenPinholes(const lms3dFusedTile& tile, lms3dRegion& region)
{
  Opener(tile, region).Open();
}
