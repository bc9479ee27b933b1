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

#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <cmath>
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

void JudgeTile(const Tile& tile, Random& random, TileTally& tally)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  lms3dTiles tiles;
  tile.Fill(tiles);
  lms3dTileCover cover = {};
  // One triangle, then another that may hide it or lie behind.
  const Vector sensor = MakeSensor(random);
  const Vector aims[2] = { tile.GetDirection(random), tile.GetDirection(random) };
  const SeenTriangle triangles[2] = { { MakeTriangleNear(aims[0], random), sensor },
    { MakeTriangleNear(aims[1], random), sensor } };
  lms3dTileMasks masks[2];
  for (int number = 0; number < 2; ++number)
  {
    const lms3dSensorFrameTriangle corners = triangles[number].GetInSensorFrame();
    masks[number] = { 1u, 0u, 0u };
    kernels.ClassifyTiles(tiles, kernels.MakeNarrowTriangle(corners, 1.0),
      lms3dGetCornerDirections(corners), 0.0f, masks[number], cover);
    tally.Unmet += masks[number].Met ? 0 : 1;
    tally.Covered += masks[number].Covered ? 1 : 0;
  }
  for (int sample = 0; sample < 20; ++sample)
  {
    const Vector direction = sample < 2 ? aims[sample] : tile.GetDirection(random);
    const double ranges[2] = { triangles[0].GetRange(direction), triangles[1].GetRange(direction) };
    const bool isHit[2] = { !std::isinf(ranges[0]), !std::isinf(ranges[1]) };
    for (int number = 0; number < 2; ++number)
    {
      tally.Wrong += masks[number].Covered && !isHit[number] ? 1 : 0;
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
