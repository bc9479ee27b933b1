// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tiles whose angles are searched for the largest rounding errors of their corners and
 * sides, and triangles that turn these errors into wrong verdicts if the bounds are too small.
 */
#include "Casting/NarrowFixtures.h"
#include "Casting/TileFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Geometry/lms3dVector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Attacks = 1000 / Fewer;

// Counts wrong verdicts on one triangle and a direction in the tile.
void JudgeDirection(
  const lms3dTiles& tiles, const Corners& corners, const Vector& direction, std::int64_t& wrong)
{
  const SeenTriangle triangle(corners, { 0.0, 0.0, 0.0 });
  lms3dTileCover cover = {};
  const lms3dTileMasks masks = ClassifyTile(tiles, triangle, lms3dBeamPacket::NoRange, cover);
  const bool isSure = masks.Covered || !masks.Met;
  const bool isHit = isSure && !std::isinf(triangle.GetRange(direction));
  wrong += isSure && isHit != (masks.Covered != 0) ? 1 : 0;
}

// Moves the angles of a tile by as little as rounding needs to be another, for as long as that
// increases what `measure` returns for it.
template <typename Measure>
Tile Worsen(Tile tile, Random& random, const Measure& measure)
{
  double worst = measure(tile);
  for (int step = 0; step < 200; ++step)
  {
    Tile next = tile;
    for (double* angle : { &next.Alpha[0], &next.Alpha[1], &next.Beta[0], &next.Beta[1] })
    {
      *angle += random.GetBits() % 2 ? random.Get(-1e-5, 1e-5) : 0.0;
    }
    const double result = measure(next);
    if (result > worst)
    {
      worst = result;
      tile = next;
    }
  }
  return tile;
}

double GetNorm(const Vector& p)
{
  return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
}

// The corner of a tile at its last turn, on the side that is not moved towards the horizon.
struct TileCorner
{
  explicit TileCorner(const Tile& tile)
    : Direction(tile.GetDirection(IsUpper(tile), 1.0))
    , Along(GetAcross(tile.GetDirection(!IsUpper(tile), 1.0) - this->Direction, this->Direction))
    , Across(GetAcross(tile.GetDirection(IsUpper(tile), 0.0) - this->Direction, this->Direction))
  {
  }

  static bool IsUpper(const Tile& tile) { return tile.Alpha[0] + tile.Alpha[1] > 0.0; }

  // Returns the normal of an edge through the corner.
  Vector GetInwards(double share) const
  {
    return Normalize(share * this->Along + (1.0 - share) * this->Across);
  }

  Vector Direction;
  Vector Along;
  Vector Across;
};

// Returns how far rounding moves a tile's corner away from an edge.
double GetShift(const Tile& tile)
{
  lms3dTiles tiles;
  tile.Fill(tiles);
  const TileCorner corner(tile);
  const float(&rounded)[3][lms3dTiles::Size] = tiles.Corner[TileCorner::IsUpper(tile) ? 2 : 1];
  const Vector error = Vector{ rounded[0][0], rounded[1][0], rounded[2][0] } - corner.Direction;
  double shift = 0.0;
  for (double share : { 0.1, 0.3, 0.5, 0.7, 0.9 })
  {
    const Vector inwards = corner.GetInwards(share);
    shift = std::max(shift, lms3dDot(inwards, error) / GetNorm(inwards));
  }
  return shift;
}

// Edges pass at a corner of the tile, by less than single precision resolves: the triangle covers
// all but the corner, or nothing but the corner.
void AttackCorner(const Tile& first, Random& random, std::int64_t& wrong)
{
  const Tile tile = Worsen(first, random, GetShift);
  lms3dTiles tiles;
  tile.Fill(tiles);
  const TileCorner corner(tile);
  const Vector& direction = corner.Direction;
  for (int attempt = 0; attempt < 200; ++attempt)
  {
    const Vector inwards = corner.GetInwards(random.Get(0.05, 0.95));
    const Vector edge = lms3dCross(inwards, direction);
    const Vector point = direction + std::pow(10.0, random.Get(-12.0, -9.0)) * inwards;
    for (double side : { 1.5, -1.5 })
    {
      JudgeDirection(
        tiles, { point + edge, point - edge, direction + side * inwards }, direction, wrong);
    }
  }
}

// Returns how far the middle of a tile's last turn lies outside one of the rounded sides.
double GetDistanceOutside(const Tile& tile)
{
  lms3dTiles tiles;
  tile.Fill(tiles);
  const Vector middle = tile.GetDirection(0.5, 1.0);
  double distance = -1.0;
  for (const auto& side : tiles.Side)
  {
    const double product = side[0][0] * middle[0] + side[1][0] * middle[1] + side[2][0] * middle[2];
    distance = std::max(distance, -product / GetNorm(middle));
  }
  return distance;
}

// A tip just reaches the middle of the tile, from either side.
void AttackSide(const Tile& first, Random& random, std::int64_t& wrong)
{
  const Tile tile = Worsen(first, random, GetDistanceOutside);
  lms3dTiles tiles;
  tile.Fill(tiles);
  const Vector middle = tile.GetDirection(0.5, 1.0);
  const Vector up = GetAcross(tile.GetDirection(1.0, 0.0), middle);
  for (double side : { 1.0, -1.0 })
  {
    const Vector step = side * lms3dCross(up, middle);
    const Vector far = middle + 0.5 * step;
    JudgeDirection(tiles, { middle - 1e-12 * step, far + 0.3 * up, far - 0.3 * up }, middle, wrong);
  }
}

// Returns how many verdicts on tiles from `make` are wrong.
std::int64_t CountWrong(
  Tile (*make)(Random&), void (*attack)(const Tile&, Random&, std::int64_t&), std::uint64_t seed)
{
  Random random(seed);
  std::int64_t wrong = 0;
  for (int i = 0; i < Attacks; ++i)
  {
    attack(make(random), random, wrong);
  }
  return wrong;
}
} // namespace

TEST(TileBounds, HoldAtCorners)
{
  EXPECT_EQ(CountWrong(&Tile::MakeSmall, &AttackCorner, 23), 0);
}

// Rounding moves a side farther than its tile is wide.
TEST(TileBounds, HoldAtSidesOfThinTiles)
{
  EXPECT_EQ(CountWrong(&Tile::MakeThin, &AttackSide, 24), 0);
}
