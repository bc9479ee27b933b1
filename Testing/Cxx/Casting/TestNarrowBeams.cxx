// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What single precision decides for beams, against exact arithmetic: at edges and corners, with
 * narrow triangles, and with planes near to the sensor or to each other.
 */
#include "Casting/NarrowFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;

// Within a few roundings of single precision of an edge or a corner, or anywhere in the triangle.
Vector MakeDirection(const Corners& corners, Random& random)
{
  std::array<double, 3> weights = { random.Get(), random.Get(), random.Get() };
  const std::uint32_t kind = random.GetBits() % 8;
  for (int i = 0; i < 3; ++i)
  {
    if (lms3dHasBit(kind, i))
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

// Two triangles one after the other: what single precision decides must be true.
struct NarrowTally
{
  std::int64_t Decided = 0;
  std::int64_t Wrong = 0;
};

void JudgePair(const Corners& first, const Corners& second, Random& random, NarrowTally& tally)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const Vector sensor = MakeSensor(random);
  const SeenTriangle triangles[] = { { first, sensor }, { second, sensor } };
  const Beams beams = MakeBeams(second, random);
  lms3dBeamPacket packet = MakePacket(beams);
  std::fill_n(packet.Triangle, Size, lms3dBeamPacket::NoTriangle);
  lms3dNarrowHits hits = {};
  double nearest[Size];
  std::fill_n(nearest, Size, lms3dBeamPacket::NoRange);
  std::uint32_t followed = 0xffffu;
  for (int number = 0; number < 2; ++number)
  {
    const lms3dNarrowTriangle narrow =
      kernels.MakeNarrowTriangle(triangles[number].GetInSensorFrame(), 1.0);
    if (narrow.PlaneError < 0.0f)
    {
      return;
    }
    const lms3dNarrowMasks masks = kernels.UpdateNarrow(narrow, number, 0xffffu, packet, hits);
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

} // namespace

TEST(NarrowBeams, AreDecidedRightly)
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
