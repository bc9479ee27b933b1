// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that blocks of planes have memory of their own, which others use after them.
 */
#include "Fusion/Cells/lms3dBlockMemory.h"
#include "Fusion/Cells/lms3dRaster.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr std::size_t Size = 4992;
// More than a page has.
constexpr int Count = 1000;

std::vector<void*> TakeAll(lms3dBlockMemory& memory)
{
  std::vector<void*> pieces;
  for (int i = 0; i < Count; ++i)
  {
    pieces.push_back(memory.Take());
    std::memset(pieces.back(), i % 256, Size);
  }
  return pieces;
}

lms3dRaster MakeRaster(std::shared_ptr<lms3dBlockMemory> memory)
{
  lms3dRaster raster(std::move(memory));
  for (int i = 0; i < Count; ++i)
  {
    raster.SetReturn(raster.Make(i, -i), i % 64, i % 63);
  }
  return raster;
}

void ExpectReturns(const lms3dRaster& raster)
{
  ASSERT_EQ(raster.GetNumberOfBlocks(), Count);
  for (int i = 0; i < Count; ++i)
  {
    EXPECT_TRUE(raster.Has(&lms3dRasterBlock::Must, 64 * i + i % 64, -64 * i + i % 63));
  }
}
} // namespace

TEST(LMS3DBlockMemory, GivesPiecesThatDoNotOverlap)
{
  lms3dBlockMemory memory(Size);
  const std::vector<void*> pieces = TakeAll(memory);
  for (int i = 0; i < Count; ++i)
  {
    const auto* const bytes = static_cast<const std::uint8_t*>(pieces[i]);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes) % 64, 0U);
    EXPECT_EQ(bytes[0], i % 256);
    EXPECT_EQ(bytes[Size - 1], i % 256);
  }
}

TEST(LMS3DBlockMemory, GivesThemAgain)
{
  lms3dBlockMemory memory(Size);
  const std::vector<void*> pieces = TakeAll(memory);
  for (void* piece : pieces)
  {
    memory.Return(piece);
  }
  const std::vector<void*> again = TakeAll(memory);
  EXPECT_EQ(
    std::set<void*>(pieces.begin(), pieces.end()), std::set<void*>(again.begin(), again.end()));
}

TEST(LMS3DBlockMemory, IsOfRastersThatAreCopiedMovedAndCleared)
{
  const auto memory = std::make_shared<lms3dBlockMemory>(sizeof(lms3dRasterBlock));
  lms3dRaster raster = MakeRaster(memory);
  lms3dRaster copy;
  copy = raster;
  const lms3dRaster moved = std::move(raster);
  ExpectReturns(copy);
  ExpectReturns(moved);
  copy.Clear();
  EXPECT_EQ(copy.GetNumberOfBlocks(), 0);
  EXPECT_EQ(copy.Find(0, 0), -1);
  lms3dRaster other = MakeRaster(memory);
  other.Clear();
  other = MakeRaster(memory);
  ExpectReturns(other);
  ExpectReturns(moved);
}
