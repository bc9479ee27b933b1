// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that creases drawn little by little have the cells of creases drawn at once.
 */
#include "Fusion/Cells/lms3dCreaseMask.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
int Count(const lms3dBits& bits)
{
  std::size_t count = 0;
  for (const std::uint64_t word : bits)
  {
    count += std::bitset<64>(word).count();
  }
  return static_cast<int>(count);
}

lms3dCreaseLine MakeCrease(double angle, double first, double last)
{
  const lms3dCreaseParts parts = { { first, last } };
  return { { 130.0 * std::cos(5.0 * angle), 130.0 * std::sin(5.0 * angle) },
    { std::cos(angle), std::sin(angle) }, { parts, parts } };
}

/// Blocks and creases that become more.
class Growth
{
public:
  explicit Growth(unsigned seed)
    : Random(seed)
  {
  }

  void Grow()
  {
    std::uniform_int_distribution<int> block(-4, 4);
    for (int i = 0; i < 12; ++i)
    {
      const int u = block(this->Random);
      this->Raster.Make(u, block(this->Random));
    }
    std::uniform_real_distribution<double> place(0.0, 100.0);
    for (lms3dCreaseLine& crease : this->Creases)
    {
      crease.Parts.Drawn.front().second += place(this->Random) > 50.0 ? 40.0 : 0.0;
    }
    const double angle = place(this->Random);
    const auto middle = static_cast<std::ptrdiff_t>(this->Creases.size() / 2);
    this->Creases.insert(
      this->Creases.begin() + middle, MakeCrease(angle, -place(this->Random), 20.0));
  }

  std::mt19937 Random;
  lms3dRaster Raster;
  std::vector<lms3dCreaseLine> Creases;
};
} // namespace

TEST(LMS3DCreaseMask, HasTheCellsOfCreasesThatAreDrawnAtOnce)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    Growth growth(seed);
    lms3dCreaseMask mask;
    for (int round = 0; round < 6; ++round)
    {
      growth.Grow();
      mask.Draw(growth.Creases, growth.Raster);
    }
    lms3dRaster copy;
    lms3dCreaseMask atOnce;
    for (int i = 0; i < growth.Raster.GetNumberOfBlocks(); ++i)
    {
      copy.Make(growth.Raster.GetBlock(i).U, growth.Raster.GetBlock(i).V);
    }
    atOnce.Draw(growth.Creases, copy);
    for (int i = 0; i < copy.GetNumberOfBlocks(); ++i)
    {
      const lms3dCreaseMask::Cells* const cells = mask.Get(i);
      const lms3dCreaseMask::Cells* const expected = atOnce.Get(i);
      ASSERT_EQ(cells == nullptr, expected == nullptr);
      if (cells)
      {
        EXPECT_EQ(cells->Line, expected->Line);
        EXPECT_EQ(cells->Near, expected->Near);
        EXPECT_EQ(
          growth.Raster.GetBlock(i).NewCreaseCells, Count(cells->Line) + Count(cells->Near));
      }
    }
  }
}

TEST(LMS3DCreaseMask, DrawsNothingTwice)
{
  lms3dRaster raster;
  raster.Make(0, 0);
  lms3dCreaseMask mask;
  const std::vector<lms3dCreaseLine> creases = { { { 0.0, 30.0 }, { 1.0, 0.0 },
    { { { 0.0, 50.0 } }, { { 0.0, 50.0 } } } } };
  mask.Draw(creases, raster);
  EXPECT_TRUE(raster.HasMark(0, lms3dRaster::DIRTY));
  const int count = raster.GetBlock(0).NewCreaseCells;
  EXPECT_GT(count, 0);
  raster.ClearMarks();
  mask.Draw(creases, raster);
  EXPECT_TRUE(raster.GetMarked().empty());
  EXPECT_EQ(raster.GetBlock(0).NewCreaseCells, count);
}
