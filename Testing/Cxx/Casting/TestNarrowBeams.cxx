// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for beams, against exact arithmetic: at edges and corners,
 * with narrow triangles, and with planes near to the sensor or to each other.
 */
#include "Casting/NarrowFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;

// How near to an edge beams pass, as powers of ten of the triangle's size: a few roundings of
// single precision, and for triangles of as small an angle as SmallSizes more of them.
constexpr double MinimumWeight = -9.0;
constexpr double MaximumWeight = -5.0;
constexpr double MaximumWeightOfSmall = -0.5;

constexpr int Pairs = 60000 / Fewer;

// Near to an edge or a corner, or anywhere in the triangle.
Vector MakeDirection(const Corners& corners, double maximumWeight, Random& random)
{
  std::array<double, 3> weights = { random.Get(), random.Get(), random.Get() };
  const std::uint32_t kind = random.GetBits() % 8;
  for (int i = 0; i < 3; ++i)
  {
    if (lms3dHasBit(kind, i))
    {
      weights[i] = std::pow(10.0, random.Get(MinimumWeight, maximumWeight)) *
        (random.GetBits() % 2 ? 1.0 : -1.0);
    }
  }
  const Vector point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  return GetLength(point) > 0.0 ? Normalize(point) : random.GetDirection();
}

Beams MakeBeams(const Corners& corners, double maximumWeight, Random& random)
{
  Beams beams;
  for (Vector& beam : beams)
  {
    beam = MakeDirection(corners, maximumWeight, random);
  }
  return beams;
}

// Two triangles one after the other: what single precision decides must be true.
struct NarrowTally
{
  std::int64_t Decided = 0;
  std::int64_t Wrong = 0;
};

// Tests one triangle against a packet, like the kernels.
using Update = lms3dNarrowMasks (*)(
  const SeenTriangle& triangle, int number, lms3dBeamPacket& packet, lms3dNarrowHits& hits);

lms3dNarrowMasks UpdateNarrow(
  const SeenTriangle& triangle, int number, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const lms3dNarrowTriangle narrow = kernels.MakeNarrowTriangle(triangle.GetInSensorFrame(), 1.0);
  return narrow.PlaneError < 0.0f ? lms3dNarrowMasks{ 0, 0xffffu }
                                  : kernels.UpdateNarrow(narrow, number, 0xffffu, packet, hits);
}

lms3dNarrowMasks UpdateFromCorners(
  const SeenTriangle& triangle, int number, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  return lms3dGetPacketKernels().UpdateFromCorners(
    triangle.GetPoints(), number, 0xffffu, packet, hits);
}

void JudgePair(
  const SeenTriangle (&triangles)[2], const Beams& beams, Update update, NarrowTally& tally)
{
  lms3dBeamPacket packet = MakePacket(beams);
  std::fill_n(packet.Triangle, Size, lms3dBeamPacket::NoTriangle);
  lms3dNarrowHits hits = {};
  double nearest[Size];
  std::fill_n(nearest, Size, lms3dBeamPacket::NoRange);
  std::uint32_t followed = 0xffffu;
  for (int number = 0; number < 2; ++number)
  {
    const lms3dNarrowMasks masks = update(triangles[number], number, packet, hits);
    // A beam in doubt would go to double precision, so it is not followed any further.
    followed &= ~masks.Uncertain;
    for (int i = 0; i < Size; ++i)
    {
      if (lms3dHasBit(followed, i))
      {
        const double range = triangles[number].GetRange(beams[i]);
        const bool isNearer = range < nearest[i];
        ++tally.Decided;
        tally.Wrong += isNearer != lms3dHasBit(masks.Changed, i) ? 1 : 0;
        nearest[i] = std::min(nearest[i], range);
      }
    }
  }
}

// `scale` multiplies all coordinates.
NarrowTally JudgePairs(
  const Exponents& sizes, double maximumWeight, Update update, double scale = 1.0)
{
  Random random(17);
  NarrowTally tally;
  for (int i = 0; i < Pairs; ++i)
  {
    const Corners second = Scale(MakeTriangle(random, sizes), scale);
    Corners first = Scale(MakeTriangle(random, sizes), scale);
    if (random.GetBits() % 2)
    {
      // Almost the same plane, nearer or farther by less than single precision resolves, or by
      // more.
      const double factor = 1.0 + std::pow(10.0, random.Get(-9.0, -3.0)) * random.Get(-1.0, 1.0);
      first = Scale(second, factor);
    }
    const Vector sensor = scale * MakeSensor(random);
    const SeenTriangle triangles[] = { { first, sensor }, { second, sensor } };
    JudgePair(triangles, MakeBeams(second, maximumWeight, random), update, tally);
  }
  return tally;
}

// From sensors a metre from the origin, so that all corners are rounded.
NarrowTally JudgeAttacks(Attack (*make)(Random&), std::size_t count, Update update)
{
  Random random(22);
  NarrowTally tally;
  for (std::size_t i = 0; i < count / Fewer; ++i)
  {
    const Attack attack = make(random);
    const Vector sensor = random.GetDirection();
    const SeenTriangle triangles[] = { { attack.First, sensor }, { attack.Second, sensor } };
    JudgePair(triangles, attack.Beams, update, tally);
  }
  return tally;
}
} // namespace

TEST(NarrowBeams, AreDecidedRightly)
{
  const NarrowTally tally = JudgePairs(AllSizes, MaximumWeight, UpdateNarrow);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Decided, static_cast<std::int64_t>(400000 / Fewer));
}

TEST(NarrowBeams, AreDecidedRightlyFromCorners)
{
  const NarrowTally tally = JudgePairs(AllSizes, MaximumWeight, UpdateFromCorners);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Decided, static_cast<std::int64_t>(400000 / Fewer));
}

TEST(NarrowBeams, AreDecidedRightlyBesideSmallTriangles)
{
  const NarrowTally tally = JudgePairs(SmallSizes, MaximumWeightOfSmall, UpdateNarrow);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Decided, static_cast<std::int64_t>(300000 / Fewer));
}

TEST(NarrowBeams, AreDecidedRightlyFromCornersOfSmallTriangles)
{
  const NarrowTally tally = JudgePairs(SmallSizes, MaximumWeightOfSmall, UpdateFromCorners);
  EXPECT_EQ(tally.Wrong, 0);
  EXPECT_GT(tally.Decided, static_cast<std::int64_t>(300000 / Fewer));
}

TEST(NarrowBeams, AreDecidedRightlyAtNeedles)
{
  for (const Update update : { UpdateNarrow, UpdateFromCorners })
  {
    EXPECT_EQ(JudgeAttacks(&MakeNeedle, 500, update).Wrong, 0);
  }
}

TEST(NarrowBeams, AreDecidedRightlyInThePlaneOfTinyTriangles)
{
  for (const Update update : { UpdateNarrow, UpdateFromCorners })
  {
    EXPECT_EQ(JudgeAttacks(&MakeTinyTriangles, 40000, update).Wrong, 0);
  }
}

// Without scaling, the edges of these triangles reach the limits of single precision.
TEST(NarrowBeams, AreDecidedRightlyFromCornersNearTheLimits)
{
  for (double scale : { 1e-9, 1e-7, 1e7, 1e9 })
  {
    SCOPED_TRACE(scale);
    const NarrowTally tally = JudgePairs(AllSizes, MaximumWeight, UpdateFromCorners, scale);
    EXPECT_EQ(tally.Wrong, 0);
    EXPECT_GT(tally.Decided, static_cast<std::int64_t>(100000 / Fewer));
  }
}

// Edges that single precision cannot hold are left to double precision.
TEST(NarrowBeams, FromCornersOfExtremeSizesAreUncertain)
{
  Beams beams;
  beams.fill({ 1.0, 0.0, 0.0 });
  for (double size : { 1e-11, 1e-9, 1.0, 1e9, 1e11 })
  {
    SCOPED_TRACE(size);
    const Corners corners = { size * Vector{ 1.0, -1.0, -1.0 }, size * Vector{ 1.0, 1.0, -1.0 },
      size * Vector{ 1.0, 0.0, 1.0 } };
    lms3dBeamPacket packet = MakePacket(beams);
    lms3dNarrowHits hits = {};
    const lms3dNarrowMasks masks =
      UpdateFromCorners(SeenTriangle(corners, Vector{ 0.0, 0.0, 0.0 }), 0, packet, hits);
    const bool isExtreme = size < 1e-10 || size > 1e10;
    EXPECT_EQ(masks.Changed, isExtreme ? 0u : 0xffffu);
    EXPECT_EQ(masks.Uncertain, isExtreme ? 0xffffu : 0u);
  }
}
