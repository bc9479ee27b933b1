// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for tiles, against exact arithmetic: at their sides and corners,
 * at poles, and with triangles that cover them or just reach them.
 */
#include "Casting/NarrowFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Size = lms3dTiles::Size;

double ToRadians(double degrees)
{
  return degrees * std::acos(-1.0) / 180.0;
}

// One tile, alone in its set: from the first to the last angle, degrees.
struct Tile
{
  double Alpha[2];
  double Beta[2];

  static Tile Make(Random& random)
  {
    const double sides[] = { 0.0, 0.25, 1.5, 7.5, 31.0, 90.0 };
    Tile tile;
    tile.Alpha[0] = random.GetBits() % 8 == 0 ? -90.0 : random.Get(-90.0, 89.0);
    tile.Alpha[1] = std::min(90.0, tile.Alpha[0] + sides[random.GetBits() % 6]);
    tile.Beta[0] = random.Get(0.0, 360.0);
    tile.Beta[1] = tile.Beta[0] + sides[random.GetBits() % 6];
    return tile;
  }

  static Vector GetDirection(double alpha, double beta)
  {
    const double a = ToRadians(alpha);
    const double b = ToRadians(beta);
    return { std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b), std::sin(a) };
  }

  Vector GetDirection(Random& random) const
  {
    double share[2];
    for (double& s : share)
    {
      const std::uint64_t kind = random.GetBits() % 4;
      s = kind < 2 ? static_cast<double>(kind) : random.Get();
    }
    return GetDirection(this->Alpha[0] + share[0] * (this->Alpha[1] - this->Alpha[0]),
      this->Beta[0] + share[1] * (this->Beta[1] - this->Beta[0]));
  }

  void Fill(lms3dTiles& tiles) const
  {
    const double half = std::cos(ToRadians(0.5 * (this->Beta[1] - this->Beta[0]))) * (1.0 - 1e-6);
    for (int end = 0; end < 2; ++end)
    {
      const double sine = std::sin(ToRadians(this->Alpha[end]));
      const bool isTowardsHorizon = end == 0 ? sine > 0.0 : sine < 0.0;
      const Vector fan = GetDirection(0.0, this->Beta[end]);
      std::fill_n(
        tiles.Cosine[end], Size, static_cast<float>(std::cos(ToRadians(this->Alpha[end]))));
      std::fill_n(tiles.Sine[end], Size, static_cast<float>(isTowardsHorizon ? sine * half : sine));
      for (int axis = 0; axis < 3; ++axis)
      {
        std::fill_n(tiles.Fan[end][axis], Size, static_cast<float>(fan[axis]));
      }
    }
    tiles.Up[0] = tiles.Up[1] = 0.0f;
    tiles.Up[2] = 1.0f;
    lms3dGetPacketKernels().FillTileCorners(tiles);
  }
};

lms3dCornerDirections GetCornerDirections(const Corners& corners)
{
  lms3dCornerDirections directions;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vector& p = corners[corner];
    const double size = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      directions.Corner[corner][axis] = static_cast<float>(p[axis] / size);
    }
  }
  return directions;
}

// A triangle with one of its corners, or a point of an edge, in the tile or at its border.
Corners MakeTriangleNear(const Tile& tile, Random& random)
{
  Corners corners = MakeTriangle(random);
  const double size = GetLength(corners[0]);
  if (random.GetBits() % 4 == 0)
  {
    // Large enough to cover the tile.
    const Vector center = tile.GetDirection(random);
    for (Vector& corner : corners)
    {
      corner = size * (center + random.Get(0.0, 3.0) * random.GetDirection());
    }
    return corners;
  }
  const Vector aim = GetLength(corners[0]) * tile.GetDirection(random);
  const Vector step = aim - (random.GetBits() % 2 ? corners[0] : 0.5 * (corners[0] + corners[1]));
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

void JudgeTile(Random& random, TileTally& tally)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const Tile tile = Tile::Make(random);
  lms3dTiles tiles;
  tile.Fill(tiles);
  lms3dTileCover cover = {};
  // One triangle, then another that may hide it or lie behind.
  Corners corners[2];
  lms3dTileMasks masks[2];
  for (int number = 0; number < 2; ++number)
  {
    corners[number] = MakeTriangleNear(tile, random);
    const lms3dNarrowTriangle narrow =
      kernels.MakeNarrowTriangle(GetInSensorFrame(corners[number]), 1.0);
    masks[number] = kernels.ClassifyTiles(
      tiles, narrow, GetCornerDirections(corners[number]), { 1u, 0u, 0u }, 0.0f, cover);
    tally.Unmet += masks[number].Met ? 0 : 1;
    tally.Covered += masks[number].Covered ? 1 : 0;
  }
  for (int sample = 0; sample < 20; ++sample)
  {
    const Vector direction = tile.GetDirection(random);
    const double ranges[2] = { GetRange(corners[0], direction), GetRange(corners[1], direction) };
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
} // namespace

TEST(NarrowTiles, AreDecidedRightly)
{
  Random random(18);
  TileTally tally;
  for (std::size_t i = 0; i < 20000 / Fewer; ++i)
  {
    JudgeTile(random, tally);
  }
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Unmet, static_cast<std::int64_t>(2000 / Fewer));
  EXPECT_GT(tally.Covered, static_cast<std::int64_t>(500 / Fewer));
}
