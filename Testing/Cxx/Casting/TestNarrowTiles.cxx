// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for tiles, against exact arithmetic: at their sides and corners,
 * at poles, and with triangles that cover them or just reach them.
 */
#include "Casting/NarrowFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dTileGrid.h"
#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dAngle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
// The direction at two angles, degrees, of a sensor that is not upright.
Vector MakeDirection(double alpha, double beta)
{
  const double a = alpha * lms3dRadiansPerDegree;
  const double b = beta * lms3dRadiansPerDegree;
  return Turn(Turn({ std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b), std::sin(a) }));
}

// A block, a tile or a packet that is a whole grid: from the first to the last angle, degrees.
struct Tile
{
  double Alpha[2];
  double Beta[2];
  int Level;

  static Tile Make(Random& random)
  {
    const double sides[] = { 0.0, 0.25, 1.5, 7.5, 31.0, 90.0 };
    Tile tile;
    tile.Alpha[0] = random.GetBits() % 8 == 0 ? -90.0 : random.Get(-90.0, 89.0);
    tile.Alpha[1] = std::min(90.0, tile.Alpha[0] + sides[random.GetBits() % 6]);
    tile.Beta[0] = random.Get(0.0, 360.0);
    tile.Beta[1] = tile.Beta[0] + sides[random.GetBits() % 6];
    tile.Level = random.GetBits() % 3;
    return tile;
  }

  static Tile MakeNearlyFromPoleToPole(Random& random)
  {
    const double alpha = 90.0 - std::pow(10.0, random.Get(-3.0, -1.0));
    const double beta = random.Get(0.0, 360.0);
    return { { -alpha, alpha }, { beta, beta + std::pow(10.0, random.Get(-1.0, 1.5)) }, 0 };
  }

  // From a quarter of the sphere on, with narrow and with wide turns.
  static Tile MakeWide(Random& random)
  {
    const double alpha = random.Get(45.0, 89.5);
    const double beta = random.Get(0.0, 360.0);
    return { { -alpha, alpha }, { beta, beta + std::pow(10.0, random.Get(-5.0, 1.95)) }, 0 };
  }

  Vector GetDirection(Random& random) const
  {
    double share[2];
    for (double& s : share)
    {
      const std::uint64_t kind = random.GetBits() % 4;
      s = kind < 2 ? static_cast<double>(kind) : random.Get();
    }
    return MakeDirection(this->Alpha[0] + share[0] * (this->Alpha[1] - this->Alpha[0]),
      this->Beta[0] + share[1] * (this->Beta[1] - this->Beta[0]));
  }

  // All sixteen tiles are the same.
  void Fill(lms3dTiles& tiles) const
  {
    const lms3dTileGrid::Area area = { this->Level, 0, 0 };
    const int side = area.GetSide();
    std::vector<Vector> fanAxes(side);
    std::vector<double> cosines(side);
    std::vector<double> sines(side);
    const double alphaStep = (this->Alpha[1] - this->Alpha[0]) / (side - 1);
    const double betaStep = (this->Beta[1] - this->Beta[0]) / (side - 1);
    for (int i = 0; i < side; ++i)
    {
      // The last angles without rounding.
      const double alpha = i == side - 1 ? this->Alpha[1] : this->Alpha[0] + i * alphaStep;
      cosines[i] = std::cos(alpha * lms3dRadiansPerDegree);
      sines[i] = std::sin(alpha * lms3dRadiansPerDegree);
      fanAxes[i] = MakeDirection(0.0, i == side - 1 ? this->Beta[1] : this->Beta[0] + i * betaStep);
    }
    const Vector up = Turn(Turn({ 0.0, 0.0, 1.0 }));
    const lms3dTileGrid grid(
      { side, side, fanAxes.data(), betaStep, cosines.data(), sines.data(), up });
    for (int i = 0; i < lms3dTiles::Size; ++i)
    {
      grid.FillTile(area, i, tiles);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      tiles.Up[axis] = static_cast<float>(up[axis]);
    }
    lms3dGetPacketKernels().FillTileCorners(tiles);
  }
};

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
    masks[number] = kernels.ClassifyTiles(tiles, kernels.MakeNarrowTriangle(corners, 1.0),
      lms3dGetCornerDirections(corners), { 1u, 0u, 0u }, 0.0f, cover);
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
