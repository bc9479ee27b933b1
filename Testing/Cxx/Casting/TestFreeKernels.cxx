// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels for beams that start at points of their own: the same bits with all
 * instruction sets, and for each beam the bits of the kernels for one origin.
 */
#include "Fixtures/BeamFixtures.h"

#include "Casting/lms3dFreePlane.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
constexpr std::int32_t Triangle = 3;
constexpr double MaximumRange = 1e6;
constexpr double MaximumDistance = 10.0;

/// Numbers of all kinds: with zeros, tiny and equal ones among them.
double GetNastyNumber(Random& random)
{
  const double sizes[] = { 0.0, 1e-9, 1.0, 1.0, 1e7 };
  const double size = sizes[random.GetBits() % 5];
  return random.GetBits() % 2 ? size * random.Get(-1.0, 1.0)
                              : std::copysign(size, random.Get(-1, 1));
}

Vector GetNastyPoint(Random& random)
{
  return { GetNastyNumber(random), GetNastyNumber(random), GetNastyNumber(random) };
}

struct Input
{
  explicit Input(Random& random)
  {
    for (Vector& point : this->Points)
    {
      point = GetNastyPoint(random);
    }
    if (random.GetBits() % 4 == 0)
    {
      this->Points[2] = this->Points[random.GetBits() % 2]; // Without area.
    }
    Beams directions;
    for (Vector& direction : directions)
    {
      direction = random.GetBits() % 4 ? random.GetDirection() : Vector{ 1.0, -1e-17, 0.0 };
    }
    const lms3dBeamPacket packet = MakePacket(directions);
    static_cast<lms3dBeamPacket&>(this->Packet) = packet;
    for (int beam = 0; beam < Size; ++beam)
    {
      const Vector start = random.GetBits() % 8 ? GetNastyPoint(random) : this->Points[0];
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Packet.Origin[axis][beam] = start[axis];
      }
      this->Packet.Range[beam] = random.GetBits() % 2 ? random.Get() : lms3dBeamPacket::NoRange;
      this->Packet.Triangle[beam] = 5;
      this->RayOffsets[beam] = random.GetBits() % 2 ? 1e3 * random.Get() : 0.0;
    }
  }

  lms3dCorners GetCorners() const
  {
    return { this->Points[0].data(), this->Points[1].data(), this->Points[2].data() };
  }

  Vector Points[3];
  lms3dFreePacket Packet;
  double RayOffsets[Size];
  lms3dSceneFrame Frame = { { 0.1, -0.2, 0.3 }, 2.0 };
};

/// All that the kernels compute of some triangle and packet.
struct Results
{
  lms3dFreePacket Packet;
  lms3dFreeStarts Starts;
  lms3dFreeMasks Masks;
  std::uint32_t Near;
  std::uint32_t NearPlane;
  std::uint32_t WellConditioned;
  float Located[3][Size];
  float Shifted[3][Size];
  float TFar[Size];
  unsigned int Geometry[Size];
  double Ranges[Size];
  double DoubleRanges[Size];
};

void Compute(const lms3dFreeKernels& kernels, const Input& input, Results& results)
{
  std::memset(static_cast<void*>(&results), 0, sizeof(results));
  const lms3dCorners corners = input.GetCorners();
  results.Packet = input.Packet;
  kernels.NarrowDirections(results.Packet);
  float* const located[3] = { results.Located[0], results.Located[1], results.Located[2] };
  results.Starts = kernels.LocateStarts(input.Frame, results.Packet, located);
  float* const shifted[3] = { results.Shifted[0], results.Shifted[1], results.Shifted[2] };
  results.Near =
    kernels.ShiftStarts(input.Frame, input.RayOffsets, MaximumDistance, results.Packet, shifted);
  results.Masks =
    kernels.UpdateNearest(corners.data(), Triangle, 0xfffb, MaximumRange, results.Packet);
  float offsets[Size];
  std::copy_n(input.RayOffsets, Size, offsets);
  std::fill_n(results.TFar, Size, 7.0f);
  kernels.ClipRays(
    results.Packet, 0xfff7, 2.0, offsets, 9, { 0, 8, results.TFar, results.Geometry });
  kernels.ClipRays(
    results.Packet, 0xfff7, 2.0, offsets, 9, { 8, 5, results.TFar + 8, results.Geometry + 8 });
  results.NearPlane =
    kernels.IntersectPlane(lms3dMakeFreePlane(corners), results.Packet, results.Ranges);
  results.WellConditioned =
    kernels.IntersectDoublePlane(corners.data(), results.Packet, results.DoubleRanges);
}

/// What the kernels for one origin compute of one beam.
struct BeamResults
{
  BeamResults(const Input& input, int beam)
    : Packet(input.Packet)
  {
    const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
    const lms3dVector origin = lms3dGetOrigin(input.Packet, beam);
    const lms3dCorners corners = input.GetCorners();
    const lms3dSensorFrameTriangle triangle = lms3dToSensorFrame(corners, origin.data());
    const std::uint32_t bit = 1u << beam;
    const lms3dHitMasks masks = kernels.Classify(triangle, bit & 0xfffb, this->Packet);
    this->Uncertain = masks.Uncertain;
    this->Changed = kernels.UpdateNearest(
      triangle, Triangle, masks.Hit, MaximumRange, this->Packet, this->Uncertain);
    const lms3dDoubleDoublePlane plane =
      kernels.MakeDoubleDoublePlane(corners.data(), origin.data());
    this->IsNearPlane = lms3dIsNearPlane(corners, origin.data(), plane);
    double ranges[Size];
    kernels.IntersectDoubleDoublePlane(plane, this->Packet, ranges);
    this->Range = ranges[beam];
    const lms3dDoublePlane doublePlane = kernels.MakeDoublePlane(triangle);
    this->IsWellConditioned = doublePlane.IsWellConditioned;
    kernels.IntersectDoublePlane(doublePlane, this->Packet, ranges);
    this->DoubleRange = ranges[beam];
  }

  lms3dBeamPacket Packet;
  std::uint32_t Changed;
  std::uint32_t Uncertain;
  bool IsNearPlane;
  bool IsWellConditioned;
  double Range;
  double DoubleRange;
};

void ExpectSameNumber(double number, double expected)
{
  EXPECT_TRUE(number == expected || (std::isnan(number) && std::isnan(expected)))
    << number << ", expected " << expected;
}

void ExpectBeam(const Results& results, const Input& input, int beam)
{
  const BeamResults expected(input, beam);
  EXPECT_EQ(results.Packet.Range[beam], expected.Packet.Range[beam]);
  EXPECT_EQ(results.Packet.Triangle[beam], expected.Packet.Triangle[beam]);
  EXPECT_EQ((results.Masks.Changed >> beam) & 1u, expected.Changed >> beam);
  EXPECT_EQ((results.Masks.Uncertain >> beam) & 1u, expected.Uncertain >> beam);
  EXPECT_EQ((results.NearPlane >> beam) & 1u, expected.IsNearPlane ? 1u : 0u);
  EXPECT_EQ((results.WellConditioned >> beam) & 1u, expected.IsWellConditioned ? 1u : 0u);
  ExpectSameNumber(results.Ranges[beam], expected.Range);
  ExpectSameNumber(results.DoubleRanges[beam], expected.DoubleRange);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(results.Packet.NarrowDirection[axis][beam], input.Packet.NarrowDirection[axis][beam]);
    float starts[Size];
    lms3dGetPacketKernels().ShiftOrigins(
      { input.Packet.Origin[axis][beam], input.RayOffsets[beam], input.Frame.Center[axis],
        input.Frame.Unit, MaximumDistance },
      input.Packet.Direction[axis], starts);
    EXPECT_EQ(results.Shifted[axis][beam], starts[beam]);
    if (input.RayOffsets[beam] == 0.0 && ((results.Near >> beam) & 1u))
    {
      // Instead of a division, a product.
      EXPECT_FLOAT_EQ(results.Located[axis][beam], starts[beam]);
    }
  }
}
} // namespace

TEST(FreeKernels, GiveTheSameBitsWithAllInstructions)
{
  Random random(31);
  for (int i = 0; i < 20000; ++i)
  {
    const Input input(random);
    Results expected;
    Compute(lms3dGetPacketKernels(0).Free, input, expected);
    for (int k = 1; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      Results results;
      Compute(lms3dGetPacketKernels(k).Free, input, results);
      ASSERT_EQ(std::memcmp(static_cast<const void*>(&results), static_cast<const void*>(&expected),
                  sizeof(results)),
        0)
        << lms3dGetPacketKernels(k).Name << ", input " << i;
    }
  }
}

TEST(FreeKernels, GiveEachBeamTheBitsOfOneOrigin)
{
  Random random(32);
  for (int i = 0; i < 2000 && !HasFailure(); ++i)
  {
    const Input input(random);
    Results results;
    Compute(lms3dGetPacketKernels().Free, input, results);
    for (int beam = 0; beam < Size; ++beam)
    {
      SCOPED_TRACE(beam);
      ExpectBeam(results, input, beam);
    }
  }
}
