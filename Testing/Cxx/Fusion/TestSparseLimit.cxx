// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks how many blocks of a raster the parts of local maps may have for each of their returns.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"
#include "Fusion/Returns/lms3dSparseParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace
{
constexpr double Cell = 0.01;

/// A right triangle with legs of a number of blocks. It is a patch of its own, or belongs to none.
struct RightPart
{
  /// The area, the perimeter and one more.
  double CountBlocks() const
  {
    return 0.5 * this->Legs * this->Legs + (2.0 + std::sqrt(2.0)) * this->Legs + 1.0;
  }

  double Legs;
  int Returns;
  bool IsPatch = true;
};

using Parts = std::vector<RightPart>;

lms3dLocalMap MakeMapOfFloor()
{
  SceneBuilder scene;
  scene.AddQuad({ -3.0, -3.0, 0.0 }, { 3.0, -3.0, 0.0 }, { 3.0, 3.0, 0.0 }, { -3.0, 3.0, 0.0 });
  const MappedScan mapped = MakeMappedScan(scene.GetSurface(), { 0.0, 0.0, 1.0 });
  const lms3dScanInput scan(mapped.Scan);
  const auto table = std::make_shared<lms3dBeamTable>(scan.GetGeometry());
  const std::vector<bool> isFree(static_cast<std::size_t>(table->GetSize()));
  return { mapped.Map, scan, lms3dSeenRanges(scan, table, isFree), Cell };
}

/// A local map with parts in place of its own.
lms3dLocalMap MakeMap(const Parts& parts)
{
  static const lms3dLocalMap Floor = MakeMapOfFloor();
  lms3dLocalMap local = Floor;
  local.Mesh = {};
  local.PatchIds.clear();
  local.Returns.clear();
  local.NumberOfPatches = 0;
  for (const RightPart& part : parts)
  {
    const auto number = static_cast<std::int32_t>(local.PatchIds.size());
    const auto first = static_cast<std::uint32_t>(local.Mesh.Points.size());
    const double leg = part.Legs * lms3dRaster::Size * Cell;
    const double height = number;
    local.Mesh.Points.push_back({ 0.0, 0.0, height });
    local.Mesh.Points.push_back({ leg, 0.0, height });
    local.Mesh.Points.push_back({ 0.0, leg, height });
    local.Mesh.Triangles.push_back({ first, first + 1, first + 2 });
    local.PatchIds.push_back(part.IsPatch ? local.NumberOfPatches++ : -1);
    local.Returns.insert(local.Returns.end(), static_cast<std::size_t>(part.Returns),
      { { 0.0, 0.0, height }, { 0.0, 0.0, 1.0 }, 1.0, 0, number });
  }
  return local;
}

/// Whether each part is sparse.
std::vector<bool> FindSparse(const Parts& parts)
{
  const lms3dLocalMap local = MakeMap(parts);
  const lms3dSparseParts sparseParts(local, Cell);
  const std::vector<int> planes =
    sparseParts.SelectDense(std::vector<int>(static_cast<std::size_t>(local.NumberOfPatches)));
  std::vector<bool> sparse;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const bool isSparse = sparseParts.IsSparseTriangle(static_cast<int>(i));
    sparse.push_back(parts[i].IsPatch ? planes[local.PatchIds[i]] < 0 : isSparse);
  }
  return sparse;
}

// 81,367 blocks: about 8, 24, 50 and 68 for each return.
constexpr RightPart Eight = { 400.0, 10000 };
constexpr RightPart TwentyFour = { 400.0, 3390 };
constexpr RightPart Fifty = { 400.0, 1627 };
constexpr RightPart SixtyEight = { 400.0, 1200 };
constexpr RightPart LooseTwentyFour = { 400.0, 3390, false };
constexpr RightPart LooseFifty = { 400.0, 1627, false };

Parts Join(Parts first, const Parts& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// `first` parts that are sparse, and `second` others that are not.
std::vector<bool> MakeSparse(std::size_t first, std::size_t second)
{
  std::vector<bool> sparse(first, true);
  sparse.resize(first + second);
  return sparse;
}
} // namespace

TEST(LMS3DSparseLimit, Is64UpToALargestNumberOfBlocks)
{
  EXPECT_EQ(FindSparse(Join({ SixtyEight }, Parts(5, Fifty))), MakeSparse(1, 5));
  EXPECT_EQ(FindSparse(Parts(6, LooseFifty)), MakeSparse(0, 6));
  // 16 for each return are more than 500,000.
  EXPECT_EQ(FindSparse(Join(Parts(2, Fifty), Parts(6, Eight))), MakeSparse(0, 8));
}

TEST(LMS3DSparseLimit, FallsTo32)
{
  EXPECT_EQ(FindSparse(Parts(7, Fifty)), MakeSparse(7, 0));
  EXPECT_EQ(FindSparse(Join(Parts(4, Fifty), Parts(3, TwentyFour))), MakeSparse(4, 3));
  EXPECT_EQ(FindSparse(Join(Parts(4, LooseFifty), Parts(3, LooseTwentyFour))), MakeSparse(4, 3));
  EXPECT_EQ(FindSparse(Join(Parts(4, LooseFifty), Parts(3, TwentyFour))), MakeSparse(4, 3));
}

TEST(LMS3DSparseLimit, FallsTo16)
{
  EXPECT_EQ(FindSparse(Parts(7, TwentyFour)), MakeSparse(7, 0));
  EXPECT_EQ(FindSparse(Join(Parts(7, LooseTwentyFour), Parts(1, Eight))), MakeSparse(7, 1));
  // The other parts have fewer than 500,000 blocks.
  EXPECT_EQ(FindSparse(Join(Parts(2, Fifty), Parts(5, TwentyFour))), MakeSparse(7, 0));
}

// A sparse part has at least 16 blocks for each return, too, since it has surface near them.
TEST(LMS3DSparseLimit, BoundsTheNumberOfBlocks)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> legs(50.0, 500.0);
  std::uniform_real_distribution<double> blocksOfReturn(4.0, 100.0);
  int bounded = 0;
  for (int i = 0; i < 100; ++i)
  {
    Parts parts(16);
    double returns = 0.0;
    for (RightPart& part : parts)
    {
      part.Legs = legs(random);
      part.Returns = static_cast<int>(part.CountBlocks() / blocksOfReturn(random));
      part.IsPatch = random() % 2 == 0;
      returns += part.Returns;
    }
    const std::vector<bool> sparse = FindSparse(parts);
    double blocks = 0.0;
    double unlimited = 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      const double count = parts[k].CountBlocks();
      EXPECT_TRUE(count > 16.0 * parts[k].Returns || !sparse[k]) << count;
      blocks += sparse[k] ? 16.0 * parts[k].Returns : count;
      unlimited += std::min(count, 64.0 * parts[k].Returns);
    }
    const double largest =
      std::max(500000.0, 16.0 * returns) + 64.0 * static_cast<double>(parts.size());
    EXPECT_LE(blocks, largest);
    bounded += unlimited > largest ? 1 : 0;
  }
  EXPECT_GT(bounded, 20);
}
