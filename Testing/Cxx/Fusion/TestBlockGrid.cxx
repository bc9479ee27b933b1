// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that a grid visits the cells of strips that have a bit, in order.
 */
#include "Fusion/Cells/lms3dBlockGrid.h"
#include "Fusion/Cells/lms3dRasterRows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace
{
using Triangle = std::array<lms3dPoint2, 3>;
using Cells = std::vector<std::pair<std::int32_t, std::int32_t>>;

constexpr lms3dRegion::BitsOf Bits = &lms3dRegionBlock::Must;

/// Most of the blocks around the origin, with random bits.
lms3dRegion MakeRegion(std::mt19937& random)
{
  std::uniform_int_distribution<std::uint64_t> word;
  lms3dRegion region;
  for (int number = 0; number < 36; ++number)
  {
    if (random() % 4 == 0)
    {
      continue;
    }
    const int block = region.Make(number % 6 - 3, number / 6 - 3);
    for (std::uint64_t& row : region.GetBlock(block).*Bits)
    {
      row = word(random);
    }
  }
  return region;
}

/// Some triangles are so thin that rows between their ends have no cell.
Triangle MakeTriangle(std::mt19937& random)
{
  std::uniform_real_distribution<double> place(-190.0, 190.0);
  std::uniform_real_distribution<double> near(-3.0, 3.0);
  Triangle triangle = {};
  for (lms3dPoint2& corner : triangle)
  {
    corner[0] = place(random);
    corner[1] = place(random);
  }
  if (random() % 2 == 0)
  {
    triangle[2] = { triangle[1][0] + near(random), triangle[1][1] + near(random) };
  }
  return triangle;
}

/// Collects cells until there are `limit`.
class Collector
{
public:
  explicit Collector(std::size_t limit)
    : Limit(limit)
  {
  }

  bool operator()(std::int32_t u, std::int32_t v)
  {
    this->Found.emplace_back(u, v);
    return this->Found.size() < this->Limit;
  }

  Cells Found;

private:
  const std::size_t Limit;
};

/// The cells of rows that have the bit, one by one.
class RowCells
{
public:
  explicit RowCells(const lms3dRegion& region)
    : Region(region)
  {
  }

  bool operator()(std::int32_t row, std::int32_t first, std::int32_t last)
  {
    for (std::int32_t u = first; u <= last; ++u)
    {
      if (this->Region.Has(Bits, u, row))
      {
        this->Found.emplace_back(u, row);
      }
    }
    return true;
  }

  Cells Found;

private:
  const lms3dRegion& Region;
};

/// `forStrips` calls its argument with the strips of a triangle.
template <typename Strips>
void ExpectCells(const lms3dRegion& region, const Cells& expected, const Strips& forStrips)
{
  for (const std::size_t limit : { expected.size() + 1, expected.size() / 2 })
  {
    if (limit == 0)
    {
      continue;
    }
    Collector collector(limit);
    const bool isWhole = forStrips([&](const lms3dCellStrip& strip)
      { return region.ForCells(Bits, strip, [&](auto u, auto v) { return collector(u, v); }); });
    EXPECT_EQ(isWhole, limit > expected.size());
    const auto end = static_cast<std::ptrdiff_t>(std::min(limit, expected.size()));
    EXPECT_EQ(collector.Found, Cells(expected.begin(), expected.begin() + end));
  }
}
} // namespace

TEST(LMS3DBlockGrid, VisitsTheCellsOfStripsThatHaveABit)
{
  std::mt19937 random(11);
  std::size_t found = 0;
  for (int i = 0; i < 200; ++i)
  {
    const lms3dRegion region = MakeRegion(random);
    const Triangle triangle = MakeTriangle(random);
    RowCells touched(region);
    lms3dForTouchedRows(triangle, [&](auto... row) { return touched(row...); });
    ExpectCells(region, touched.Found,
      [&](const auto& visit) { return lms3dForTouchedStrips(triangle, visit); });
    RowCells centres(region);
    lms3dForCentreStrips(triangle,
      [&](const lms3dCellStrip& strip)
      { return lms3dForRows(strip, [&](auto... row) { return centres(row...); }); });
    ExpectCells(region, centres.Found,
      [&](const auto& visit) { return lms3dForCentreStrips(triangle, visit); });
    found += centres.Found.size();
  }
  EXPECT_GT(found, 10000U);
}
