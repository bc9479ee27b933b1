// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks what of a fused map is made anew, and the parts from which this is found out.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"
#include "Fusion/lms3dBalls.h"
#include "Fusion/lms3dBlockParts.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

namespace
{
constexpr int Size = lms3dRaster::Size;
using Grid = std::array<std::array<int, Size>, Size>;

lms3dBits MakeBits(double share, unsigned seed)
{
  std::mt19937 generator(seed);
  std::bernoulli_distribution isSet(share);
  lms3dBits bits = {};
  for (std::uint64_t& word : bits)
  {
    for (int place = 0; place < Size; ++place)
    {
      word |= static_cast<std::uint64_t>(isSet(generator)) << place;
    }
  }
  return bits;
}

/// Gives all cells that are connected with a cell its number.
void Flood(const lms3dBits& bits, int v, int u, int number, Grid& numbers)
{
  std::vector<std::array<int, 2>> cells = { { v, u } };
  while (!cells.empty())
  {
    const auto [row, place] = cells.back();
    cells.pop_back();
    if (row < 0 || row >= Size || place < 0 || place >= Size || numbers[row][place] >= 0 ||
      (bits[row] >> place & 1U) == 0)
    {
      continue;
    }
    numbers[row][place] = number;
    cells.insert(cells.end(),
      { { row - 1, place }, { row + 1, place }, { row, place - 1 }, { row, place + 1 } });
  }
}

std::set<int> GetRegions(vtkDataArray* numbers)
{
  std::set<int> regions;
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    regions.insert(static_cast<int>(numbers->GetTuple1(i)));
  }
  return regions;
}
} // namespace

TEST(LMS3DBlockParts, AreThoseOfAFlood)
{
  for (const double share : { 0.05, 0.4, 0.6, 0.7, 1.0 })
  {
    const lms3dBits bits = MakeBits(share, 7);
    Grid expected;
    for (auto& row : expected)
    {
      row.fill(-1);
    }
    int count = 0;
    for (int v = 0; v < Size; ++v)
    {
      for (int u = 0; u < Size; ++u)
      {
        if ((bits[v] >> u & 1U) != 0 && expected[v][u] < 0)
        {
          Flood(bits, v, u, count++, expected);
        }
      }
    }
    const lms3dBlockParts parts(bits);
    EXPECT_EQ(parts.GetCount(), count);
    lms3dBits found = {};
    parts.ForRuns(
      [&](int part, int row, std::uint64_t run)
      {
        found[row] |= run;
        for (int u = 0; u < Size; ++u)
        {
          if ((run >> u & 1U) != 0)
          {
            ASSERT_EQ(part, expected[row][u]);
          }
        }
      });
    EXPECT_EQ(found, bits);
  }
}

TEST(LMS3DBalls, KeepHalfOfTheWayToTheNearestOtherCell)
{
  lms3dRaster raster;
  for (int number = 0; number < 9; ++number)
  {
    lms3dRasterBlock& block = raster.GetBlock(raster.Make(number % 3, number / 3));
    block.Must = MakeBits(0.002, static_cast<unsigned>(number));
  }
  const lms3dRasterBlock& middle = raster.GetBlock(4);
  const lms3dBits centres = MakeBits(0.01, 11);
  std::set<std::array<int, 2>> expected;
  for (int v = 0; v < Size; ++v)
  {
    for (int u = 0; u < Size; ++u)
    {
      if ((centres[v] >> u & 1U) == 0)
      {
        continue;
      }
      int nearest = 32;
      for (int row = -Size; row < 2 * Size; ++row)
      {
        for (int place = -Size; place < 2 * Size; ++place)
        {
          if (raster.Has(&lms3dRasterBlock::Must, Size + place, Size + row))
          {
            nearest = std::min(nearest, std::max(std::abs(row - v), std::abs(place - u)));
          }
        }
      }
      const int radius = (nearest - 1) / 2;
      for (int row = -radius; row <= radius; ++row)
      {
        for (int place = -radius; place <= radius; ++place)
        {
          if (row * row + place * place <= radius * radius)
          {
            expected.insert({ v + row, u + place });
          }
        }
      }
    }
  }
  std::set<std::array<int, 2>> found;
  const lms3dBalls balls(centres, lms3dBlockWindow(raster, middle, &lms3dRasterBlock::Must));
  balls.ForRows(
    [&](int row, const std::array<std::uint64_t, 3>& words)
    {
      for (int u = 0; u < 3 * Size; ++u)
      {
        if ((words[u / Size] >> (u % Size) & 1U) != 0)
        {
          found.insert({ row, u - Size });
        }
      }
    });
  EXPECT_EQ(found, expected);
}

TEST(LMS3DBalls, LookForCellsNearABlock)
{
  lms3dRaster raster;
  for (int number = 0; number < 9; ++number)
  {
    raster.GetBlock(raster.Make(number % 3, number / 3)).Must =
      MakeBits(0.0005, static_cast<unsigned>(20 + number));
  }
  const lms3dBits found =
    lms3dBlockWindow(raster, raster.GetBlock(4), &lms3dRasterBlock::Must).GetCellsNear();
  constexpr int Reach = lms3dBlockWindow::LargestRadius;
  for (int v = 0; v < Size; ++v)
  {
    for (int u = 0; u < Size; ++u)
    {
      const lms3dCellBox box = { Size + u - Reach, Size + u + Reach, Size + v - Reach,
        Size + v + Reach };
      ASSERT_EQ((found[v] >> u & 1U) != 0, raster.HasAny(&lms3dRasterBlock::Must, box));
    }
  }
}

// The rooms have walls in the same planes, but no view into each other.
TEST(LMS3DFusedRegions, StayInAnotherRoom)
{
  SceneBuilder scene;
  scene.AddBox({ -4.0, -3.0, 0.0 }, { 4.0, 3.0, 2.5 });
  scene.AddBox({ 20.0, -3.0, 0.0 }, { 28.0, 3.0, 2.5 });
  vtkNew<vtkLMS3DMapFusion> fusion;
  AddAll({ MakeMappedScan(scene.GetSurface(), { 0.0, 0.0, 1.2 }),
           MakeMappedScan(scene.GetSurface(), { 1.0, 0.5, 1.2 }) },
    fusion);
  fusion->Update();
  const std::set<int> before = GetRegions(fusion->GetOutput()->GetCellData()->GetArray("RegionId"));
  const int revision = fusion->GetRevision();
  AddAll({ MakeMappedScan(scene.GetSurface(), { 24.0, 0.0, 1.2 }) }, fusion);
  vtkNew<vtkPolyData> delta;
  fusion->GetChanges(revision, delta);
  const std::set<int> changed = GetRegions(delta->GetFieldData()->GetArray("ChangedRegions"));
  EXPECT_GT(delta->GetNumberOfPolys(), 0);
  EXPECT_TRUE(std::none_of(
    before.begin(), before.end(), [&](int region) { return changed.count(region) > 0; }));
}
