// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCreaseCut.h"

#include "Fusion/lms3dRasterRows.h"

#include <array>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;
// Cells: how far a crease reaches beyond its parts.
constexpr double ReachAlong = 12.0;
// Cells: returns nearer to a crease may be of the other plane.
constexpr double ReachAcross = 8.0;

/// Grows bits in a row through all bits of `free`.
std::uint64_t Fill(std::uint64_t bits, std::uint64_t free)
{
  std::uint64_t left = bits & free;
  std::uint64_t right = left;
  std::uint64_t freeLeft = free;
  std::uint64_t freeRight = free;
  for (int step = 1; step <= Last; step *= 2)
  {
    left |= freeLeft & (left << step);
    freeLeft &= freeLeft << step;
    right |= freeRight & (right >> step);
    freeRight &= freeRight >> step;
  }
  return left | right;
}

/// Floods a region from its returns. Guess are the cells of creases, Covered the cells near them.
class Flood
{
public:
  explicit Flood(const lms3dRaster& region)
    : Region(region)
    , Filled(static_cast<std::size_t>(region.GetNumberOfBlocks()), lms3dBits{})
    , IsQueued(Filled.size(), true)
  {
    for (int number = 0; number < region.GetNumberOfBlocks(); ++number)
    {
      const lms3dRasterBlock& block = region.GetBlock(number);
      for (int row = 0; row <= Last; ++row)
      {
        this->Filled[number][row] = block.Must[row] & ~block.Covered[row];
      }
      this->Queue.push_back(number);
    }
  }

  void Run()
  {
    while (!this->Queue.empty())
    {
      const int number = this->Queue.back();
      this->Queue.pop_back();
      this->IsQueued[number] = false;
      this->Grow(number);
    }
  }

  /// The cells that were reached.
  std::uint64_t GetRow(int number, int row) const { return this->Filled[number][row]; }

private:
  std::uint64_t Get(std::int32_t u, std::int32_t v, int row) const
  {
    const int number = this->Region.Find(u, v);
    return number < 0 ? 0 : this->Filled[number][row];
  }

  /// The cells of a row that have a reached neighbour.
  std::uint64_t GetAround(const lms3dRasterBlock& block, int number, int row) const
  {
    const lms3dBits& filled = this->Filled[number];
    const std::uint64_t below = row > 0 ? filled[row - 1] : this->Get(block.U, block.V - 1, Last);
    const std::uint64_t above = row < Last ? filled[row + 1] : this->Get(block.U, block.V + 1, 0);
    return below | above | filled[row] << 1 | filled[row] >> 1 |
      this->Get(block.U - 1, block.V, row) >> Last | this->Get(block.U + 1, block.V, row) << Last;
  }

  void Grow(int number)
  {
    const lms3dRasterBlock& block = this->Region.GetBlock(number);
    const lms3dBits before = this->Filled[number];
    for (bool isGrowing = true; isGrowing;)
    {
      isGrowing = false;
      for (int step = 0; step < 2 * lms3dRaster::Size; ++step)
      {
        const int row = step <= Last ? step : 2 * Last + 1 - step;
        const std::uint64_t free = block.May[row] & ~block.Guess[row];
        std::uint64_t& word = this->Filled[number][row];
        const std::uint64_t grown =
          Fill(word | (this->GetAround(block, number, row) & free), free) | word;
        isGrowing = isGrowing || grown != word;
        word = grown;
      }
    }
    if (before != this->Filled[number])
    {
      for (const auto& [u, v] : Neighbours)
      {
        this->Add(this->Region.Find(block.U + u, block.V + v));
      }
    }
  }

  void Add(int number)
  {
    if (number >= 0 && !this->IsQueued[number])
    {
      this->IsQueued[number] = true;
      this->Queue.push_back(number);
    }
  }

  static constexpr std::array<std::array<int, 2>, 4> Neighbours = { { { -1, 0 }, { 1, 0 },
    { 0, -1 }, { 0, 1 } } };

  const lms3dRaster& Region;
  std::vector<lms3dBits> Filled;
  std::vector<bool> IsQueued;
  std::vector<int> Queue;
};

/// Sets a bit of the cells of a crease, `width` cells to both sides.
void Draw(
  const lms3dCreaseLine& crease, lms3dRaster::BitsOf bits, double width, lms3dRaster& region)
{
  for (const auto& [first, last] : crease.Parts)
  {
    std::array<lms3dPoint2, 4> corners = {};
    for (int i = 0; i < 4; ++i)
    {
      const double along = i == 0 || i == 3 ? first - ReachAlong : last + ReachAlong;
      const double across = i < 2 ? -width : width;
      corners[i] = { crease.Point[0] + along * crease.Direction[0] - across * crease.Direction[1],
        crease.Point[1] + along * crease.Direction[1] + across * crease.Direction[0] };
    }
    lms3dForTouchedRows(corners,
      [&](std::int32_t row, std::int32_t from, std::int32_t to)
      {
        region.SetRow(bits, row, from, to, true, false, [](int) {});
        return true;
      });
  }
}
} // namespace

void lms3dCutAtCreases(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& region)
{
  if (creases.empty())
  {
    return;
  }
  for (const lms3dCreaseLine& crease : creases)
  {
    Draw(crease, &lms3dRasterBlock::Guess, 0.0, region);
    Draw(crease, &lms3dRasterBlock::Covered, ReachAcross, region);
  }
  Flood flood(region);
  flood.Run();
  for (int number = 0; number < region.GetNumberOfBlocks(); ++number)
  {
    lms3dRasterBlock& block = region.GetBlock(number);
    for (int row = 0; row <= Last; ++row)
    {
      block.May[row] &= flood.GetRow(number, row) | block.Must[row] | block.Covered[row];
    }
  }
}
