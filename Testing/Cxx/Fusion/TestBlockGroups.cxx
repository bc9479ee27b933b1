// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which blocks of a plane lie beside one another, and in which groups they lie.
 */
#include "Fusion/Planes/lms3dBlockGroups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace
{
constexpr double Cell = 0.003; // metres

const lms3dPlaneFrame Frame({ 1.0, -2.0, 0.5 }, { 0.6, 0.0, 0.8 }, Cell, { 0.0, 0.0, 0.0 });

/// Adds blocks anywhere near the origin. Some of them exist already.
void AddBlocks(int count, unsigned seed, lms3dRaster& raster)
{
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i)
  {
    const auto u = static_cast<std::int32_t>(random() % 12U) - 6;
    const auto v = static_cast<std::int32_t>(random() % 12U) - 6;
    raster.Make(u, v);
  }
}

bool HasBlock(const lms3dBlockGroup& group, const lms3dRasterBlock& block)
{
  return group.Left <= block.U && block.U <= group.Right && group.Bottom <= block.V &&
    block.V <= group.Top;
}

// Whether the sphere around a group has a block.
bool IsAround(const lms3dBlockGroup& group, const lms3dRasterBlock& block)
{
  const lms3dVector centre = group.GetCentre(Frame);
  for (const int u : { block.U, block.U + 1 })
  {
    for (const int v : { block.V, block.V + 1 })
    {
      const lms3dVector corner =
        Frame.ToWorld({ 1.0 * u * lms3dRaster::Size, 1.0 * v * lms3dRaster::Size });
      if (lms3dGetLength(lms3dSubtract(corner, centre)) > group.GetRadius(Frame))
      {
        return false;
      }
    }
  }
  return true;
}

// Expects each block from one on in one group.
void ExpectGroups(const lms3dBlockGroups& groups, const lms3dRaster& raster)
{
  for (int i = groups.GetFirstBlock(); i < raster.GetNumberOfBlocks(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    EXPECT_EQ(std::count_if(groups.Get().begin(), groups.Get().end(),
                [&](const lms3dBlockGroup& group)
                { return HasBlock(group, block) && IsAround(group, block); }),
      1);
  }
  for (const lms3dBlockGroup& group : groups.Get())
  {
    EXPECT_LE(group.Right - group.Left, 1);
    EXPECT_LE(group.Top - group.Bottom, 1);
  }
}
} // namespace

TEST(LMS3DBlockGroups, HaveAllBlocksOfAPlaneThatGrows)
{
  lms3dRaster raster;
  lms3dBlockGroups groups;
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    AddBlocks(12, seed, raster);
    groups.Update(raster);
    ExpectGroups(groups, raster);
  }
  EXPECT_GT(groups.Get().size(), 10U);
  EXPECT_LT(groups.Get().size(), static_cast<std::size_t>(raster.GetNumberOfBlocks()));
}

TEST(LMS3DBlockGroups, HaveNoBlockBeforeTheFirst)
{
  lms3dRaster raster;
  raster.Make(100, 100);
  AddBlocks(20, 1, raster);
  const lms3dBlockGroups groups(raster, 1);
  ExpectGroups(groups, raster);
  EXPECT_TRUE(std::none_of(groups.Get().begin(), groups.Get().end(),
    [&](const lms3dBlockGroup& group) { return HasBlock(group, raster.GetBlock(0)); }));
}

TEST(LMS3DRasterBlocks, HaveTheNumbersOfTheBlocksAround)
{
  lms3dRaster raster;
  AddBlocks(100, 3, raster);
  int neighbors = 0;
  for (int number = 0; number < raster.GetNumberOfBlocks(); ++number)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (int i = 0; i < 9; ++i)
    {
      const int expected = raster.Find(block.U + i % 3 - 1, block.V + i / 3 - 1);
      EXPECT_EQ(block.Around[i], expected);
      neighbors += expected >= 0 ? 1 : 0;
    }
    EXPECT_EQ(block.Around[4], number);
  }
  EXPECT_GT(neighbors, 2 * raster.GetNumberOfBlocks());
}
