// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks what of a fused map is made anew, and the parts from which this is found out.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/Cells/lms3dBlockParts.h"
#include "Fusion/Cells/lms3dRegionRaster.h"
#include "Fusion/FusionFixtures.h"

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

/// Row and place, from the first block on.
using Cell = std::array<int, 2>;
using CellSet = std::set<Cell>;

CellSet GetCells(const lms3dRaster& raster, lms3dRaster::BitsOf bits)
{
  CellSet cells;
  for (int v = 0; v < 3 * Size; ++v)
  {
    for (int u = 0; u < 3 * Size; ++u)
    {
      if (raster.Has(bits, u, v))
      {
        cells.insert({ v, u });
      }
    }
  }
  return cells;
}

CellSet Subtract(CellSet cells, const CellSet& others)
{
  for (const Cell& cell : others)
  {
    cells.erase(cell);
  }
  return cells;
}

CellSet Unite(CellSet cells, const CellSet& others)
{
  cells.insert(others.begin(), others.end());
  return cells;
}

/// Adds the cells at most `reach` cells away along both axes.
CellSet Widen(const CellSet& cells, int reach)
{
  CellSet wide;
  for (const auto& [v, u] : cells)
  {
    for (int row = v - reach; row <= v + reach; ++row)
    {
      for (int place = u - reach; place <= u + reach; ++place)
      {
        wide.insert({ row, place });
      }
    }
  }
  return wide;
}

/// The cells whose surroundings, eight cells along both axes, are all set.
CellSet Narrow(const CellSet& cells)
{
  CellSet narrow;
  for (const auto& [v, u] : cells)
  {
    bool isInside = true;
    for (int row = v - 8; row <= v + 8 && isInside; ++row)
    {
      for (int place = u - 8; place <= u + 8 && isInside; ++place)
      {
        isInside = cells.count({ row, place }) > 0;
      }
    }
    if (isInside)
    {
      narrow.insert({ v, u });
    }
  }
  return narrow;
}

bool HasNeighbor(const CellSet& cells, const Cell& cell)
{
  for (int v = -1; v <= 1; ++v)
  {
    for (int u = -1; u <= 1; ++u)
    {
      if (cells.count({ cell[0] + v, cell[1] + u }) > 0)
      {
        return true;
      }
    }
  }
  return false;
}

CellSet AddCross(const CellSet& cells)
{
  CellSet wide = cells;
  for (const auto& [v, u] : cells)
  {
    wide.insert({ { v - 1, u }, { v + 1, u }, { v, u - 1 }, { v, u + 1 } });
  }
  return wide;
}

/// Both grow by turns along four and eight directions; cells that both reach at once go to neither.
void Race(CellSet& first, CellSet& second)
{
  for (int step = 1; step <= 15; ++step)
  {
    const CellSet a = Subtract(step % 2 == 1 ? AddCross(first) : Widen(first, 1), second);
    const CellSet b = Subtract(step % 2 == 1 ? AddCross(second) : Widen(second, 1), first);
    first = Subtract(a, b);
    second = Subtract(b, a);
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

namespace
{
/// Compares with cells that are looked at one by one. Counts cells of no map that the region has
/// since returns are near, and cells of a map that it has not.
struct RaceResult
{
  int Given = 0;
  int Taken = 0;
};

RaceResult CompareWithRace(double shareOfPassed)
{
  lms3dRaster raster;
  for (int number = 0; number < 9; ++number)
  {
    lms3dRasterBlock& block = raster.GetBlock(raster.Make(number % 3, number / 3));
    const auto seed = static_cast<unsigned>(4 * number);
    block.May = MakeBits(0.1, seed);
    block.Must = MakeBits(0.006, seed + 1);
    block.Passed = MakeBits(shareOfPassed, seed + 2);
    block.Open = MakeBits(0.3, seed + 3);
    block.HasPassed = shareOfPassed > 0.0;
    block.HasOpen = true;
  }
  const CellSet passed = GetCells(raster, &lms3dRasterBlock::Passed);
  const CellSet may = GetCells(raster, &lms3dRasterBlock::May);
  const CellSet must = GetCells(raster, &lms3dRasterBlock::Must);
  CellSet returns = Subtract(must, passed);
  CellSet beams = passed;
  Race(returns, beams);
  const CellSet base =
    Subtract(Unite(Subtract(may, GetCells(raster, &lms3dRasterBlock::Open)), must), passed);
  const CellSet closed = Unite(Narrow(Widen(base, 8)), may);
  const lms3dRegionCells found = lms3dMakeRegionCells(raster, 4);
  RaceResult result;
  for (int v = 0; v < Size; ++v)
  {
    for (int u = 0; u < Size; ++u)
    {
      const Cell cell = { Size + v, Size + u };
      const bool isNearReturn = returns.count(cell) > 0 && closed.count(cell) > 0;
      const bool isNearBeam = beams.count(cell) > 0;
      const bool isSure = must.count(cell) > 0 && !HasNeighbor(passed, cell);
      const bool isBase = base.count(cell) > 0;
      EXPECT_EQ((found.Must[v] >> u & 1U) != 0, isSure);
      EXPECT_EQ((found.May[v] >> u & 1U) != 0, isSure || isNearReturn || (isBase && !isNearBeam));
      result.Given += isNearReturn && !isBase ? 1 : 0;
      result.Taken += isBase && isNearBeam ? 1 : 0;
    }
  }
  return result;
}
} // namespace

TEST(LMS3DRegionCells, AreThoseOfARaceCellByCell)
{
  const RaceResult result = CompareWithRace(0.004);
  EXPECT_GT(result.Given, 100);
  EXPECT_GT(result.Taken, 10);
}

TEST(LMS3DRegionCells, AreThoseNearReturnsIfNoBeamPassed)
{
  const RaceResult result = CompareWithRace(0.0);
  EXPECT_GT(result.Given, 100);
  EXPECT_EQ(result.Taken, 0);
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

// The tiles of a plane lie around the place where the first scan saw it.
TEST(LMS3DFusedRegions, AreNotDividedIfTheyAreSmall)
{
  for (const double shift : { 0.0, 2.0, 3.4, 40.1 })
  {
    SceneBuilder scene;
    scene.AddBox({ shift - 3.0, shift - 2.5, 0.0 }, { shift + 3.0, shift + 2.5, 2.5 });
    vtkNew<vtkLMS3DMapFusion> fusion;
    AddAll({ MakeMappedScan(scene.GetSurface(), { shift, shift, 1.2 }),
             MakeMappedScan(scene.GetSurface(), { shift + 0.5, shift - 0.3, 1.2 }) },
      fusion);
    fusion->Update();
    const std::set<int> regions =
      GetRegions(fusion->GetOutput()->GetCellData()->GetArray("RegionId"));
    EXPECT_EQ(regions.size(), 6U) << shift;
  }
}
