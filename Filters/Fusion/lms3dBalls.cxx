// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dBalls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{
constexpr int Last = lms3dRaster::Size - 1;

/// Half of the width of a ball with a radius, in each row above its centre.
class Widths
{
public:
  Widths()
  {
    for (int radius = 0; radius < Count; ++radius)
    {
      for (int row = 0; row <= radius; ++row)
      {
        this->Values[radius][row] =
          static_cast<int>(std::sqrt(static_cast<double>(radius * radius - row * row)));
      }
    }
  }

  int Get(int radius, int row) const { return this->Values[radius][std::abs(row)]; }

private:
  static constexpr int Count = lms3dBlockWindow::Margin / 2;
  std::array<std::array<int, Count>, Count> Values = {};
};
} // namespace

// Adds the block beside the middle by u and v.
void lms3dBlockWindow::Add(int u, int v, const lms3dBits& bits)
{
  const int first = v < 0 ? lms3dRaster::Size - Margin : 0;
  const int end = v > 0 ? Margin : lms3dRaster::Size;
  for (int row = first; row < end; ++row)
  {
    this->Rows[row + v * lms3dRaster::Size + Margin][u + 1] = bits[row];
    this->HasNone = this->HasNone && bits[row] == 0;
  }
}

std::uint64_t lms3dBlockWindow::GetWord(int u, int row) const
{
  const std::array<std::uint64_t, 3>& words = this->Rows[row + Margin];
  const int start = lms3dRaster::Size + u - (Margin - 1);
  const int word = start / lms3dRaster::Size;
  const int shift = start % lms3dRaster::Size;
  return shift == 0 ? words[word]
                    : words[word] >> shift | words[word + 1] << (lms3dRaster::Size - shift);
}

int lms3dBlockWindow::GetDistance(int u, int v) const
{
  constexpr int Centre = Margin - 1;
  int nearest = Margin;
  for (int row = 0; row < nearest && !this->HasNone; ++row)
  {
    // The cells that are nearer than the nearest so far.
    const std::uint64_t word = (this->GetWord(u, v + row) | this->GetWord(u, v - row)) &
      (~std::uint64_t{ 0 } >> (Last - 2 * (nearest - 1))) << (Margin - nearest);
    for (int width = 0; word != 0 && width < nearest; ++width)
    {
      if (((word >> (Centre + width) | word >> (Centre - width)) & 1U) != 0)
      {
        nearest = std::max(row, width);
      }
    }
  }
  return nearest;
}

lms3dBits lms3dBlockWindow::GetCellsNear() const
{
  // Shifts of 1, 2, 4 and 8 cells reach 15 cells.
  constexpr std::array<int, 4> Shifts = { 1, 2, 4, 8 };
  constexpr int Beyond = lms3dRaster::Size - LargestRadius;
  std::array<std::uint64_t, lms3dRaster::Size + 2 * LargestRadius> wide;
  for (std::size_t row = 0; row < wide.size(); ++row)
  {
    const auto& [left, middle, right] = this->Rows[row + Margin - LargestRadius];
    std::uint64_t up = middle | right << Beyond;
    std::uint64_t down = middle | left >> Beyond;
    for (const int shift : Shifts)
    {
      up |= up << shift;
      down |= down >> shift;
    }
    wide[row] = up | down;
  }
  // Each row gets the rows above it, as far as the window of 31 rows reaches.
  for (const int shift : Shifts)
  {
    for (std::size_t row = 0; row + shift < wide.size(); ++row)
    {
      wide[row] |= wide[row + shift];
    }
  }
  lms3dBits near;
  for (std::size_t row = 0; row < near.size(); ++row)
  {
    near[row] = wide[row] | wide[row + LargestRadius];
  }
  return near;
}

lms3dBalls::lms3dBalls(const lms3dBits& centres, const lms3dBlockWindow& others)
{
  for (int row = 0; row <= Last; ++row)
  {
    for (int place = 0; place <= Last && centres[row] >> place != 0; ++place)
    {
      if ((centres[row] >> place & 1U) != 0)
      {
        this->Add(place, row, (others.GetDistance(place, row) - 1) / 2);
      }
    }
  }
}

void lms3dBalls::Add(int u, int v, int radius)
{
  static const Widths widths;
  for (int row = -radius; row <= radius; ++row)
  {
    const int width = widths.Get(radius, row);
    const std::uint64_t bits = ~std::uint64_t{ 0 } >> (Last - 2 * width);
    const int start = lms3dRaster::Size + u - width;
    std::array<std::uint64_t, 3>& words = this->Rows[v + row + Largest + 1];
    const int word = start / lms3dRaster::Size;
    const int shift = start % lms3dRaster::Size;
    words[word] |= bits << shift;
    if (shift != 0 && word < 2)
    {
      words[word + 1] |= bits >> (lms3dRaster::Size - shift);
    }
  }
}
