// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief No tile misses a box that one of its beams meets: boxes that a beam just touches at a
 * corner, an edge or a face, near the tile's sides and corners.
 */
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
// The half size that reaches from a centre in single precision to both ends, rounded up.
float GetHalfSize(float center, double low, double high)
{
  const double half = std::max(high - center, center - low);
  return std::nextafter(static_cast<float>(half), HUGE_VALF);
}

// A box that has a point within it, often on its surface. Sizes are between none and much more than
// the distance.
lms3dTileBox MakeBoxAt(const Vector& point, Random& random)
{
  lms3dTileBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::uint64_t kind = random.GetBits() % 4;
    const double size = random.GetBits() % 8 == 0 ? 0.0 : std::pow(10.0, random.Get(-8.0, 1.0));
    const double share = kind < 2 ? static_cast<double>(kind) : random.Get();
    const double low = point[axis] - share * size;
    const double high = point[axis] + (1.0 - share) * size;
    box.Center[axis] = static_cast<float>(0.5 * (low + high));
    box.HalfSize[axis] = GetHalfSize(box.Center[axis], low, high);
  }
  return box;
}

struct BoxTally
{
  std::int64_t Missed = 0;

  /// Boxes elsewhere that no tile meets.
  std::int64_t Excluded = 0;
};

BoxTally JudgeBoxes(Tile (*make)(Random&), std::size_t count, std::uint64_t seed)
{
  const auto findTiles = lms3dGetPacketKernels().FindTilesOfBox;
  Random random(seed);
  BoxTally tally;
  for (std::size_t i = 0; i < count / Fewer; ++i)
  {
    const Tile tile = make(random);
    lms3dTiles tiles;
    tile.Fill(tiles);
    for (int sample = 0; sample < 20; ++sample)
    {
      const double distance = std::pow(10.0, random.Get(-6.0, 0.0));
      const Vector met = distance * tile.GetDirection(random);
      tally.Missed += findTiles(tiles, MakeBoxAt(met, random)) == 0xffffu ? 0 : 1;
      const Vector other = distance * random.GetDirection();
      tally.Excluded += findTiles(tiles, MakeBoxAt(other, random)) == 0 ? 1 : 0;
    }
  }
  return tally;
}
} // namespace

TEST(TileBoxes, AreMetByTilesWithABeamTowardsThem)
{
  const BoxTally tally = JudgeBoxes(&Tile::Make, 20000, 31);
  EXPECT_EQ(tally.Missed, 0);
  EXPECT_GT(tally.Excluded, static_cast<std::int64_t>(100000 / Fewer));
}

TEST(TileBoxes, AreMetByTilesNearlyFromPoleToPole)
{
  EXPECT_EQ(JudgeBoxes(&Tile::MakeNearlyFromPoleToPole, 10000, 32).Missed, 0);
}

TEST(TileBoxes, AreMetByTilesOfManyBeams)
{
  EXPECT_EQ(JudgeBoxes(&Tile::MakeWide, 20000, 33).Missed, 0);
}

// The sensor is in the box, so it lies in all directions.
TEST(TileBoxes, AroundTheSensorAreMetByAllTiles)
{
  Random random(34);
  for (int i = 0; i < 1000; ++i)
  {
    lms3dTiles tiles;
    Tile::Make(random).Fill(tiles);
    EXPECT_EQ(
      lms3dGetPacketKernels().FindTilesOfBox(tiles, MakeBoxAt({ 0.0, 0.0, 0.0 }, random)), 0xffffu);
  }
}
