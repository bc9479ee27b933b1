// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks how the cells are counted in which a mesh differs from the shape of its plane.
 */
#include "Fusion/Cells/lms3dCreaseMask.h"
#include "Fusion/Cells/lms3dRegionShape.h"
#include "Fusion/Outlines/lms3dFusedTile.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
// The columns with returns.
constexpr std::uint64_t Left = 0xfffffff;

int Count(std::uint64_t word)
{
  return static_cast<int>(std::bitset<lms3dRaster::Size>(word).count());
}

/// A crease across the block at 0, 0.
std::vector<lms3dCreaseLine> MakeCreases()
{
  const lms3dCreaseParts parts = { { 0.0, 70.0 } };
  return { { { 10.0, 5.0 }, { 0.6, 0.8 }, { parts, parts } } };
}

/// The cells near the crease.
lms3dBits GetNear()
{
  lms3dRaster raster;
  raster.Make(0, 0);
  lms3dCreaseMask mask;
  mask.Draw(MakeCreases(), raster);
  return mask.Get(0)->Near;
}
} // namespace

// The mesh has random cells. Returns leave no gap in the left part of the block.
TEST(LMS3DShapeDifferences, CountCellsThatAShapeGainedOrLost)
{
  lms3dRaster raster;
  lms3dRasterBlock& block = raster.GetBlock(raster.Make(0, 0));
  std::mt19937_64 random(7);
  for (int row = 0; row < lms3dRaster::Size; ++row)
  {
    block.Must[row] = random() & Left;
    block.Meshed[row] = random();
  }
  raster.SetMark(0, lms3dRaster::DIRTY);
  lms3dRegionShape().Update(MakeCreases(), raster);
  const lms3dBits near = GetNear();
  int all = 0;
  int gained = 0;
  int lost = 0;
  for (int row = 0; row < lms3dRaster::Size; ++row)
  {
    all += Count(block.Shape[row] ^ block.Meshed[row]);
    gained += Count(block.Shape[row] & ~block.Meshed[row] & near[row]);
    lost += Count(block.Meshed[row] & ~block.Shape[row] & near[row]);
  }
  EXPECT_GT(gained, 0);
  EXPECT_GT(lost, 0);
  EXPECT_GT(all, gained + lost);
  EXPECT_EQ(block.Difference, all);
  EXPECT_EQ(block.DifferenceAtCreases, gained + lost);
}

TEST(LMS3DShapeDifferences, LeaveATileUpToTheirLimits)
{
  lms3dFusedTile tile(0, 0);
  tile.Blocks.resize(20);
  tile.DifferenceAtCreases = 64;
  EXPECT_FALSE(tile.HasOtherShape());
  tile.DifferenceAtCreases = 65;
  EXPECT_TRUE(tile.HasOtherShape());
  // 16 cells for each block.
  tile.DifferenceAtCreases = 0;
  tile.Difference = 335;
  EXPECT_FALSE(tile.HasOtherShape());
  tile.Difference = 336;
  EXPECT_TRUE(tile.HasOtherShape());
  tile.Blocks.resize(1);
  tile.Difference = 256;
  EXPECT_FALSE(tile.HasOtherShape());
}
