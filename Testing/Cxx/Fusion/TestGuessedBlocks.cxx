// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the guesses that are found and cleared in polygons with a look at the centre of each
 * cell.
 */
#include "Fusion/Passages/lms3dGuessedBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace
{
using Cells = std::vector<std::pair<std::int32_t, std::int32_t>>;

constexpr int Size = lms3dRaster::Size;
constexpr double Pi = 3.14159265358979323846;

/// Some blocks around a block have guesses: half of their cells if `isDense`, else a single cell.
/// Others have none. They are made in no order.
lms3dRaster MakeRaster(std::int32_t u, std::int32_t v, bool isDense, std::mt19937_64& random)
{
  lms3dRaster raster;
  for (int i = 0; i < 36; ++i)
  {
    const auto kind = random() % 4;
    if (kind == 0)
    {
      continue;
    }
    const int place = i * 23 % 36;
    const int number = raster.Make(u + place % 6 - 3, v + place / 6 - 3);
    raster.SetMark(number, lms3dRaster::SEEN);
    if (kind == 1)
    {
      continue;
    }
    lms3dBits& guess = raster.GetBlock(number).Guess;
    guess[random() % Size] = std::uint64_t{ 1 } << random() % Size;
    for (std::uint64_t& row : guess)
    {
      row = isDense ? random() : row;
    }
    raster.SetMark(number, lms3dRaster::GUESSED);
  }
  return raster;
}

Cells GetGuesses(const lms3dRaster& raster)
{
  Cells guesses;
  for (int number = 0; number < raster.GetNumberOfBlocks(); ++number)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (int cell = 0; cell < Size * Size; ++cell)
    {
      if ((block.Guess[cell / Size] >> cell % Size & 1U) != 0)
      {
        guesses.emplace_back(block.U * Size + cell % Size, block.V * Size + cell / Size);
      }
    }
  }
  return guesses;
}

/// Whether the centre of a cell lies in a polygon whose corners are counter-clockwise.
bool IsIn(const lms3dCutPolygon& polygon, const Cells::value_type& cell)
{
  const lms3dPoint2 centre = { cell.first + 0.5, cell.second + 0.5 };
  bool isIn = true;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const lms3dPoint2& next = polygon[(i + 1) % polygon.size()];
    isIn = isIn && lms3dGetOrientation(polygon[i], next, centre) >= 0;
  }
  return isIn;
}

/// Points of an ellipse, which may be thin, counter-clockwise.
template <std::size_t Count>
std::array<lms3dPoint2, Count> MakeConvex(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::array<double, Count> angles = {};
  std::generate(angles.begin(), angles.end(), [&] { return Pi * any(random); });
  std::sort(angles.begin(), angles.end());
  const lms3dPoint2 centre = { 100.0 * any(random), 100.0 * any(random) };
  const double turn = Pi * any(random);
  const double half = 150.0 * std::abs(any(random));
  const double narrow = random() % 2 == 0 ? std::abs(any(random)) : half;
  std::array<lms3dPoint2, Count> points = {};
  for (std::size_t i = 0; i < Count; ++i)
  {
    const double along = half * std::cos(angles[i]);
    const double across = narrow * std::sin(angles[i]);
    points[i] = { centre[0] + along * std::cos(turn) - across * std::sin(turn),
      centre[1] + along * std::sin(turn) + across * std::cos(turn) };
  }
  return points;
}

template <typename Points>
lms3dCutPolygon MakePolygon(const Points& points)
{
  lms3dCutPolygon polygon;
  for (const lms3dPoint2& point : points)
  {
    polygon.Add(point);
  }
  return polygon;
}

/// The part of a quadrilateral on one side of a line. It has up to five corners, or none.
lms3dCutPolygon MakeClipped(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const double angle = Pi * any(random);
  const double height = 100.0 * any(random);
  std::array<lms3dCutCorner, 4> corners = {};
  const std::array<lms3dPoint2, 4> points = MakeConvex<4>(random);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { points[i], points[i][0] * std::cos(angle) + points[i][1] * std::sin(angle) };
  }
  return lms3dClip(corners, height);
}

/// A strip of 40 cells with a length of 1e9 cells through a place.
lms3dCutPolygon MakeLong(const lms3dPoint2& place, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> share(0.1, 0.9);
  const double angle = 2.0 * Pi * share(random);
  const lms3dPoint2 along = { std::cos(angle), std::sin(angle) };
  const double end = 1e9 * share(random);
  lms3dCutPolygon polygon;
  for (const lms3dPoint2& corner : std::array<lms3dPoint2, 4>{
         { { end - 1e9, -20.0 }, { end, -20.0 }, { end, 20.0 }, { end - 1e9, 20.0 } } })
  {
    polygon.Add({ place[0] + corner[0] * along[0] - corner[1] * along[1],
      place[1] + corner[0] * along[1] + corner[1] * along[0] });
  }
  return polygon;
}

/// Returns how many guesses lie in a polygon.
std::size_t ExpectGuesses(const lms3dCutPolygon& polygon, lms3dRaster raster)
{
  const Cells all = GetGuesses(raster);
  Cells outside;
  std::copy_if(all.begin(), all.end(), std::back_inserter(outside),
    [&](const Cells::value_type& cell) { return !IsIn(polygon, cell); });
  const lms3dGuessedBlocks blocks(raster);
  EXPECT_EQ(blocks.HasAny(polygon, raster), outside.size() < all.size());
  EXPECT_EQ(GetGuesses(raster), all);
  blocks.Clear(polygon, raster);
  EXPECT_EQ(GetGuesses(raster), outside);
  EXPECT_FALSE(blocks.HasAny(polygon, raster));
  return all.size() - outside.size();
}
} // namespace

TEST(LMS3DGuessedBlocks, HaveGuessesWhereCentresLieInAPolygon)
{
  std::mt19937_64 random(5);
  int without = 0;
  std::array<int, 6> withCorners = {};
  for (int i = 0; i < 600; ++i)
  {
    const lms3dCutPolygon polygon =
      i % 3 == 0 ? MakePolygon(MakeConvex<3>(random)) : MakeClipped(random);
    const lms3dRaster raster = MakeRaster(0, 0, i % 2 == 0, random);
    if (polygon.size() >= 3)
    {
      const std::size_t found = ExpectGuesses(polygon, raster);
      without += found == 0 ? 1 : 0;
      withCorners[polygon.size()] += found > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(without, 100);
  EXPECT_GT(withCorners[3], 30);
  EXPECT_GT(withCorners[4], 30);
  EXPECT_GT(withCorners[5], 10);
}

// A search through all rows of the polygons would take minutes.
TEST(LMS3DGuessedBlocks, HaveGuessesInPolygonsThatAreVeryLong)
{
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> any(-9e8, 9e8);
  for (int i = 0; i < 100; ++i)
  {
    const lms3dPoint2 place = { any(random), any(random) };
    const lms3dRaster raster = MakeRaster(lms3dRaster::GetBlockOf(lms3dGetCellOf(place[0])),
      lms3dRaster::GetBlockOf(lms3dGetCellOf(place[1])), true, random);
    EXPECT_GT(ExpectGuesses(MakeLong(place, random), raster), 100U);
  }
}

// The polygons differ in one corner.
TEST(LMS3DGuessedBlocks, HaveNoGuessesInPolygonsBeyondAllCells)
{
  std::mt19937_64 random(7);
  lms3dRaster raster = MakeRaster(0, 0, true, random);
  const auto makePolygon = [](double far)
  {
    return MakePolygon(
      std::array<lms3dPoint2, 3>{ { { -90.3, -80.1 }, { far, 70.2 }, { 0.0, 90.4 } } });
  };
  EXPECT_GT(ExpectGuesses(makePolygon(1.999e9), raster), 1000U);
  const Cells all = GetGuesses(raster);
  const lms3dGuessedBlocks blocks(raster);
  for (const double far : { 2.001e9, 1e30, std::numeric_limits<double>::infinity() })
  {
    EXPECT_FALSE(blocks.HasAny(makePolygon(far), raster)) << far;
    blocks.Clear(makePolygon(far), raster);
    EXPECT_EQ(GetGuesses(raster), all) << far;
  }
}

// The polygon begins 2.8e9 cells before the blocks, more than a number of 32 bits can tell.
TEST(LMS3DGuessedBlocks, HaveGuessesFarFromTheEndsOfAPolygon)
{
  std::mt19937_64 random(8);
  const lms3dRaster raster = MakeRaster(15000000, 0, true, random);
  const lms3dCutPolygon polygon = MakePolygon(std::array<lms3dPoint2, 4>{
    { { -1.9e9, -20.0 }, { 1.9e9, -20.0 }, { 1.9e9, 20.0 }, { -1.9e9, 20.0 } } });
  EXPECT_GT(ExpectGuesses(polygon, raster), 100U);
}
