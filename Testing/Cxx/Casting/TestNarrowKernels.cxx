// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for beams and tiles, against exact arithmetic.
 *
 * Triangles and beams are chosen where the error bounds of lms3dNarrowTriangle.h and lms3dTile.h are
 * most likely to fail: beams at edges and corners, narrow triangles, and planes near to the sensor.
 */
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
const Vector Sensor = { 0.0, 0.0, 0.0 };

using Corners = std::array<Vector, 3>;

lms3dCorners GetPointers(const Corners& corners)
{
  return { corners[0].data(), corners[1].data(), corners[2].data() };
}

// From a millimetre to a hundred metres away; every other one is very narrow or seen nearly edge-on.
Corners MakeTriangle(Random& random)
{
  const double distance = std::pow(10.0, random.Get(-3.0, 2.0));
  const double size = distance * std::pow(10.0, random.Get(-4.0, 1.0));
  const Vector a = distance * random.GetDirection();
  const Vector p = size * random.GetDirection();
  Vector q = size * random.GetDirection();
  switch (random.GetBits() % 4)
  {
    case 0:
      q = random.Get(-1.0, 1.0) * p + std::pow(10.0, random.Get(-8.0, -1.0)) * q;
      break;
    case 1:
      q = random.Get(-1.0, 1.0) * p + random.Get(-1.0, 1.0) * a +
        std::pow(10.0, random.Get(-9.0, -2.0)) * q;
      break;
    default:
      break;
  }
  return { a, a + p, a + q };
}

// Within a few roundings of single precision of an edge or a corner, or anywhere in the triangle.
Vector MakeDirection(const Corners& corners, Random& random)
{
  std::array<double, 3> weights = { random.Get(), random.Get(), random.Get() };
  const std::uint64_t kind = random.GetBits() % 8;
  for (int i = 0; i < 3; ++i)
  {
    if ((kind >> i) & 1u)
    {
      weights[i] = std::pow(10.0, random.Get(-9.0, -5.0)) * (random.GetBits() % 2 ? 1.0 : -1.0);
    }
  }
  const Vector point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  return GetLength(point) > 0.0 ? Normalize(point) : random.GetDirection();
}

Beams MakeBeams(const Corners& corners, Random& random)
{
  Beams beams;
  for (Vector& beam : beams)
  {
    beam = MakeDirection(corners, random);
  }
  return beams;
}

// The range with all digits; infinite where the beam passes by or the triangle is behind.
double GetRange(const Corners& corners, const Vector& direction)
{
  const lms3dCorners pointers = GetPointers(corners);
  if (!lms3dIsInside(pointers, Sensor.data(), direction.data()))
  {
    return lms3dBeamPacket::NoRange;
  }
  double ranges[Size];
  lms3dIntersectNearPlane(pointers, Sensor.data(), MakePacket(MakeSame(direction)), ranges);
  return ranges[0] > 0.0 ? ranges[0] : lms3dBeamPacket::NoRange;
}

// Two triangles one after the other: what single precision decides must be true.
struct NarrowTally
{
  std::int64_t Decided = 0;
  std::int64_t Wrong = 0;
};

void JudgePair(const Corners& first, const Corners& second, Random& random, NarrowTally& tally)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const Corners* triangles[] = { &first, &second };
  const Beams beams = MakeBeams(second, random);
  lms3dBeamPacket packet = MakePacket(beams);
  std::fill_n(packet.Triangle, Size, lms3dBeamPacket::NoTriangle);
  lms3dNarrowHits hits = {};
  double nearest[Size];
  std::fill_n(nearest, Size, lms3dBeamPacket::NoRange);
  std::uint32_t followed = 0xffffu;
  for (int number = 0; number < 2; ++number)
  {
    const lms3dNarrowTriangle narrow = kernels.MakeNarrowTriangle(
      lms3dToSensorFrame(GetPointers(*triangles[number]), Sensor.data()), 1.0);
    if (narrow.PlaneError < 0.0f)
    {
      return;
    }
    const lms3dNarrowMasks masks = kernels.UpdateNarrow(narrow, number, 0xffffu, packet, hits);
    // A beam in doubt would go to double precision, so it is not followed any further.
    followed &= ~masks.Uncertain;
    for (int i = 0; i < Size; ++i)
    {
      if ((followed >> i) & 1u)
      {
        const double range = GetRange(*triangles[number], beams[i]);
        const bool isNearer = range < nearest[i];
        ++tally.Decided;
        tally.Wrong += isNearer != (((masks.Changed >> i) & 1u) != 0) ? 1 : 0;
        nearest[i] = std::min(nearest[i], range);
      }
    }
  }
}

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
    const lms3dNarrowTriangle narrow = kernels.MakeNarrowTriangle(
      lms3dToSensorFrame(GetPointers(corners[number]), Sensor.data()), 1.0);
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

TEST(NarrowKernels, AreRightAboutBeamsWhereTheyAreSure)
{
  Random random(17);
  NarrowTally tally;
  for (std::size_t i = 0; i < 60000 / Fewer; ++i)
  {
    const Corners second = MakeTriangle(random);
    Corners first = MakeTriangle(random);
    if (random.GetBits() % 2)
    {
      // Almost the same plane, nearer or farther by less than single precision resolves, or by more.
      const double factor = 1.0 + std::pow(10.0, random.Get(-9.0, -3.0)) * random.Get(-1.0, 1.0);
      first = { factor * second[0], factor * second[1], factor * second[2] };
    }
    JudgePair(first, second, random, tally);
  }
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Decided, static_cast<std::int64_t>(400000 / Fewer));
}

TEST(NarrowKernels, AreRightAboutTilesWhereTheyAreSure)
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
