// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for tiles, against exact arithmetic: at their sides and
 * corners, at poles, and with triangles that cover them or just reach them.
 */
#include "Casting/NarrowFixtures.h"
#include "Casting/TileFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace
{
// A triangle with one of its corners, its centre or a point of an edge along `aim`.
Corners MakeTriangleNear(const Vector& aim, Random& random)
{
  Corners corners = MakeTriangle(random);
  const double size = GetLength(corners[0]);
  if (random.GetBits() % 4 == 0)
  {
    // Large enough to cover the tile.
    for (Vector& corner : corners)
    {
      corner = size * (aim + random.Get(0.0, 3.0) * random.GetDirection());
    }
    return corners;
  }
  const Vector points[] = { corners[0], 0.5 * (corners[0] + corners[1]),
    1.0 / 3.0 * (corners[0] + corners[1] + corners[2]) };
  const Vector step = size * aim - points[random.GetBits() % 3];
  for (Vector& corner : corners)
  {
    corner = corner + step;
  }
  return corners;
}

struct TileTally
{
  std::int64_t Unmet = 0;
  std::int64_t Covered = 0;
  std::int64_t Wrong = 0;
};

// Two triangles: the second may hide the first or lie behind it.
struct Scene
{
  SeenTriangle Triangles[2];

  /// Metres.
  double MaximumRange;
};

// A scale next to 1, by what single precision may or may not resolve.
double GetScale(Random& random)
{
  return GetNearlyOne(random, -9.0, -5.0);
}

// In half of the cases the triangles have almost the same plane. In half of these the maximum range
// is almost that of a corner of the tile.
Scene MakeScene(const Tile& tile, const Vector (&aims)[2], Random& random)
{
  const Vector sensor = MakeSensor(random);
  const Corners first = MakeTriangleNear(aims[0], random);
  if (random.GetBits() % 2)
  {
    return { { { first, sensor }, { MakeTriangleNear(aims[1], random), sensor } },
      lms3dBeamPacket::NoRange };
  }
  const Corners second = Scale(first, GetScale(random));
  Scene scene = { { { first, sensor }, { second, sensor } }, lms3dBeamPacket::NoRange };
  if (random.GetBits() % 2)
  {
    return scene;
  }
  scene.MaximumRange = 0.0;
  for (const double alpha : { 0.0, 1.0 })
  {
    for (const double beta : { 0.0, 1.0 })
    {
      scene.MaximumRange =
        std::max(scene.MaximumRange, scene.Triangles[0].GetRange(tile.GetDirection(alpha, beta)));
    }
  }
  scene.MaximumRange *= GetScale(random);
  return scene;
}

void JudgeTile(const Tile& tile, Random& random, TileTally& tally)
{
  lms3dTiles tiles;
  tile.Fill(tiles);
  lms3dTileCover cover = {};
  const Vector aims[2] = { tile.GetDirection(random), tile.GetDirection(random) };
  const Scene scene = MakeScene(tile, aims, random);
  lms3dTileMasks masks[2];
  for (int number = 0; number < 2; ++number)
  {
    masks[number] = ClassifyTile(tiles, scene.Triangles[number], scene.MaximumRange, cover);
    tally.Unmet += masks[number].Met ? 0 : 1;
    tally.Covered += masks[number].Covered ? 1 : 0;
  }
  for (int sample = 0; sample < 20; ++sample)
  {
    const Vector direction = sample < 2 ? aims[sample] : tile.GetDirection(random);
    const double ranges[2] = { scene.Triangles[0].GetRange(direction),
      scene.Triangles[1].GetRange(direction) };
    const bool isHit[2] = { !std::isinf(ranges[0]), !std::isinf(ranges[1]) };
    for (int number = 0; number < 2; ++number)
    {
      const bool isWithin = isHit[number] && ranges[number] <= scene.MaximumRange;
      tally.Wrong += masks[number].Covered && !isWithin ? 1 : 0;
    }
    tally.Wrong += !masks[0].Met && isHit[0] ? 1 : 0;
    // The second may be hidden by the first.
    tally.Wrong += !masks[1].Met && isHit[1] && ranges[1] <= ranges[0] ? 1 : 0;
    tally.Wrong += masks[0].Nearest && masks[1].Nearest && ranges[1] >= ranges[0] ? 1 : 0;
  }
}

// Judges tiles from `make`.
TileTally JudgeTiles(Tile (*make)(Random&), std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  TileTally tally;
  for (std::size_t i = 0; i < count / Fewer; ++i)
  {
    JudgeTile(make(random), random, tally);
  }
  return tally;
}
} // namespace

TEST(NarrowTiles, AreDecidedRightly)
{
  const TileTally tally = JudgeTiles(&Tile::Make, 20000, 18);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Unmet, static_cast<std::int64_t>(2000 / Fewer));
  EXPECT_GT(tally.Covered, static_cast<std::int64_t>(500 / Fewer));
}

// The corners of such a tile are so near to the planes of its sides that rounding can turn a side.
TEST(NarrowTiles, NearlyFromPoleToPoleAreDecidedRightly)
{
  const TileTally tally = JudgeTiles(&Tile::MakeNearlyFromPoleToPole, 10000, 20);
  EXPECT_EQ(tally.Wrong, 0);
}

TEST(NarrowTiles, OfManyBeamsAreDecidedRightly)
{
  const TileTally tally = JudgeTiles(&Tile::MakeWide, 20000, 21);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Unmet, static_cast<std::int64_t>(1000 / Fewer));
}
