// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels of all instruction sets that this processor has.
 */
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>

namespace
{
/// All that the kernels compute of some triangle and packet.
struct KernelResults
{
  lms3dBeamPacket Aimed;
  lms3dBeamPacket Taken;
  lms3dBeamPacket Kept;
  lms3dBeamPacket Finished;
  lms3dDoubleDoublePlane Plane;
  double Ranges[lms3dBeamPacket::Size];
  double DoubleRanges[lms3dBeamPacket::Size];
  double Points[lms3dBeamPacket::Size][3];
  float Origins[lms3dBeamPacket::Size];
  float TFar[lms3dBeamPacket::Size];
  unsigned int Geometry[lms3dBeamPacket::Size];
  lms3dNarrowHits Narrow;
  lms3dHitMasks Masks;
  std::uint32_t Changed;
  std::uint32_t Uncertain;
  std::uint32_t InCone;
  std::uint32_t Near;
  std::uint32_t Hits;
  std::uint32_t Measured;
};

/// What the kernels are given, of all kinds: with zeros, tiny and equal numbers among them.
struct KernelInput
{
  explicit KernelInput(Random& random)
  {
    for (Vector& corner : this->Corners)
    {
      corner = { GetNastyNumber(random), GetNastyNumber(random), GetNastyNumber(random) };
    }
    this->Origin = { GetNastyNumber(random), GetNastyNumber(random), GetNastyNumber(random) };
    if (random.GetBits() % 4 == 0)
    {
      this->Corners[2] = this->Corners[random.GetBits() % 2]; // Without area.
    }
    if (random.GetBits() % 8 == 0)
    {
      this->Origin = this->Corners[0];
    }
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      const Vector axis = random.GetBits() % 2 ? random.GetDirection() : Vector{ 1.0, -1e-17, 0.0 };
      this->Elevations.Cosine[i] = GetNastyNumber(random) / 1e7;
      this->Elevations.Sine[i] = random.Get(-1.0, 1.0);
      for (int k = 0; k < 3; ++k)
      {
        this->Axes.Horizontal[k][i] = axis[k];
        this->Axes.Up[k] = k == 2 ? 1.0 : 0.0;
      }
    }
  }

  /// Moves corner 0 close to the line of a beam, so that two edges hardly decide on it.
  void GrazeCorner(Random& random)
  {
    const std::size_t beam = random.GetBits() % lms3dBeamPacket::Size;
    const double size = random.Get(1.0, 100.0);
    const Vector offset = random.GetDirection();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double direction = this->Elevations.Cosine[beam] * this->Axes.Horizontal[axis][beam] +
        this->Elevations.Sine[beam] * this->Axes.Up[axis];
      this->Corners[0][axis] =
        this->Origin[axis] + size * (direction + 3.0 * lms3dNarrowError * offset[axis]);
    }
  }

  static double GetNastyNumber(Random& random)
  {
    const double sizes[] = { 0.0, 1e-9, 1.0, 1.0, 1e7 };
    const double size = sizes[random.GetBits() % 5];
    return random.GetBits() % 2 ? size * random.Get(-1.0, 1.0)
                                : std::copysign(size, random.Get(-1, 1));
  }

  Vector Corners[3];
  Vector Origin;
  lms3dElevations Elevations;
  lms3dFanAxes Axes;
};

void ComputeBeams(
  const lms3dPacketKernels& kernels, const KernelInput& input, KernelResults& results)
{
  const lms3dBeamPacket& packet = results.Taken;
  const lms3dShiftedOrigin start = { input.Origin[0], 2.0, input.Corners[0][0], 3.0, 10.0 };
  results.Near = kernels.ShiftOrigins(start, packet.Direction[0], results.Origins);
  const Vector& axis = input.Corners[1];
  results.InCone = kernels.FindInCone({ { axis[0], axis[1], axis[2] }, 0.5 }, packet);
  std::fill_n(results.TFar, lms3dBeamPacket::Size, 7.0f);
  kernels.NarrowRanges(packet, results.Changed, 3.0, results.Narrow);
  kernels.ClipRays(
    results.Narrow, results.Changed, 0.25f, 9, { 0, 8, results.TFar, results.Geometry });
  kernels.ClipRays(
    results.Narrow, results.Changed, 0.25f, 9, { 8, 5, results.TFar + 8, results.Geometry + 8 });
  const lms3dReturnsOfTurn returns = { input.Elevations.Cosine, input.Elevations.Sine, packet.Range,
    lms3dBeamPacket::Size - 1, input.Corners[0].data(), input.Corners[1].data(),
    input.Origin.data() };
  kernels.Locate(returns, results.Points[0]);
}

void ComputeRanges(const lms3dPacketKernels& kernels, const lms3dCorners& corners,
  const KernelInput& input, KernelResults& results)
{
  results.Plane = kernels.MakeDoubleDoublePlane(corners.data(), input.Origin.data());
  kernels.IntersectDoubleDoublePlane(results.Plane, results.Taken, results.Ranges);
  const lms3dDoubleDoublePlane& plane = results.Plane;
  kernels.IntersectDoublePlane(
    { { plane.Normal[0].High, plane.Normal[1].High, plane.Normal[2].High }, plane.Offset.High, 0.0,
      true },
    results.Taken, results.DoubleRanges);
  results.Kept = results.Taken;
  results.Measured = kernels.StoreRanges(results.Ranges, 3, 10.0, results.Kept);
  results.Hits = kernels.FindHits(results.Kept);
  results.Finished = results.Kept;
  kernels.ApplyMinimumRange(0.5, results.Finished);
}

/// The bytes of the results.
std::string Compute(const lms3dPacketKernels& kernels, const KernelInput& input)
{
  const lms3dCorners corners = { input.Corners[0].data(), input.Corners[1].data(),
    input.Corners[2].data() };
  KernelResults results;
  std::memset(static_cast<void*>(&results), 0, sizeof(results));
  lms3dBeamPacket& packet = results.Aimed;
  kernels.GenerateDirections(input.Elevations, input.Axes, packet);
  std::fill_n(packet.Range, lms3dBeamPacket::Size, 1.0);
  std::fill_n(packet.Triangle, lms3dBeamPacket::Size, 5);
  packet.Active = 0x7fffu;
  const lms3dSensorFrameTriangle triangle = lms3dToSensorFrame(corners, input.Origin.data());
  results.Masks = kernels.Classify(triangle, 0xfffb, packet);
  results.Taken = packet;
  results.Changed =
    kernels.UpdateNearest(triangle, 3, 0xffffu, 1e6, results.Taken, results.Uncertain);
  ComputeBeams(kernels, input, results);
  ComputeRanges(kernels, corners, input, results);
  return { reinterpret_cast<const char*>(&results), sizeof(results) };
}

/// What the kernels compute in single precision.
struct NarrowResults
{
  lms3dNarrowTriangle Triangle;
  lms3dBeamPacket Packet;
  lms3dNarrowHits Hits;
  lms3dNarrowMasks Masks;
  lms3dBeamPacket PacketOfCorners;
  lms3dNarrowHits HitsOfCorners;
  lms3dNarrowMasks MasksOfCorners;
  lms3dTiles Tiles;
  lms3dTileCover Cover;
  lms3dTileMasks TileMasks;
};

void FillTiles(const KernelInput& input, lms3dTiles& tiles)
{
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    for (int end = 0; end < 2; ++end)
    {
      tiles.Cosine[end][i] = static_cast<float>(input.Elevations.Sine[(i + end) % 16]);
      tiles.Sine[end][i] = static_cast<float>(input.Elevations.Sine[(i + end + 2) % 16]);
      for (int axis = 0; axis < 3; ++axis)
      {
        tiles.Fan[end][axis][i] = static_cast<float>(input.Axes.Horizontal[axis][(i + end) % 16]);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    tiles.Up[axis] = static_cast<float>(input.Axes.Up[axis]);
  }
}

NarrowResults ComputeNarrow(const lms3dPacketKernels& kernels, const KernelInput& input)
{
  const lms3dCorners corners = { input.Corners[0].data(), input.Corners[1].data(),
    input.Corners[2].data() };
  NarrowResults results;
  std::memset(static_cast<void*>(&results), 0, sizeof(results));
  kernels.GenerateDirections(input.Elevations, input.Axes, results.Packet);
  std::fill_n(results.Hits.InverseRange, lms3dBeamPacket::Size, 0.25f);
  const lms3dSensorFrameTriangle inSensorFrame = lms3dToSensorFrame(corners, input.Origin.data());
  const lms3dNarrowTriangle triangle = kernels.MakeNarrowTriangle(inSensorFrame, 2.0);
  FillTiles(input, results.Tiles);
  kernels.FillTileCorners(results.Tiles);
  lms3dTileMasks& masks = results.TileMasks;
  masks = { 0xfffb, 0, 0 };
  kernels.ClassifyTiles(
    results.Tiles, triangle, lms3dGetCornerDirections(inSensorFrame), 0.1f, masks, results.Cover);
  if (triangle.PlaneError >= 0.0f)
  {
    // Without the bytes behind the last number, which have any value.
    std::memcpy(&results.Triangle, &triangle, offsetof(lms3dNarrowTriangle, PlaneError));
    results.Triangle.PlaneError = triangle.PlaneError;
    results.Masks = kernels.UpdateNarrow(triangle, 7, 0xfffb, results.Packet, results.Hits);
  }
  results.PacketOfCorners = results.Packet;
  results.HitsOfCorners = results.Hits;
  results.MasksOfCorners =
    kernels.UpdateFromCorners({ { corners[0], corners[1], corners[2] }, input.Origin.data(), 2.0 },
      8, 0xfffb, results.PacketOfCorners, results.HitsOfCorners);
  return results;
}

/// Returns whether the hits of the beams that changed for both agree within their errors.
bool AgreeOnRanges(const lms3dNarrowHits& a, const lms3dNarrowHits& b, std::uint32_t changed)
{
  bool agree = true;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    agree &= ((changed >> i) & 1u) == 0 ||
      std::abs(a.InverseRange[i] - b.InverseRange[i]) <= a.Error[i] + b.Error[i];
  }
  return agree;
}

/// Returns whether the covers of the tiles that are covered for both agree within their errors.
bool AgreeOnRanges(const lms3dTileCover& a, const lms3dTileCover& b, std::uint32_t covered)
{
  bool agree = true;
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      agree &= ((covered >> i) & 1u) == 0 ||
        std::abs(a.InverseRange[corner][i] - b.InverseRange[corner][i]) <= a.Error[i] + b.Error[i];
    }
  }
  return agree;
}

bool AgreeOnRanges(const NarrowResults& a, const NarrowResults& b)
{
  return AgreeOnRanges(a.Hits, b.Hits, a.Masks.Changed & b.Masks.Changed) &&
    AgreeOnRanges(
      a.HitsOfCorners, b.HitsOfCorners, a.MasksOfCorners.Changed & b.MasksOfCorners.Changed) &&
    AgreeOnRanges(a.Cover, b.Cover, a.TileMasks.Nearest & b.TileMasks.Nearest);
}

/// Returns whether what `results` is sure of is at least possible for `others`.
bool Allow(const NarrowResults& others, const NarrowResults& results)
{
  const auto allow = [](const lms3dNarrowMasks& possible, const lms3dNarrowMasks& sure)
  { return (sure.Changed & ~(possible.Changed | possible.Uncertain)) == 0; };
  return (results.TileMasks.Covered & ~others.TileMasks.Met) == 0 &&
    allow(others.Masks, results.Masks) && allow(others.MasksOfCorners, results.MasksOfCorners);
}

template <typename T>
std::string GetBytes(const T& value)
{
  return { reinterpret_cast<const char*>(&value), sizeof(value) };
}

/// The prepared triangle, beams and tiles, which all instruction sets make alike.
std::string GetPrepared(const NarrowResults& results)
{
  return GetBytes(results.Triangle) + GetBytes(results.Packet.NarrowDirection) +
    GetBytes(results.Tiles);
}

/// What is decided on tiles and beams.
std::string GetDecided(const NarrowResults& results)
{
  return GetBytes(results.TileMasks) + GetBytes(results.Cover) + GetBytes(results.Masks) +
    GetBytes(results.Hits) + GetBytes(results.Packet.Triangle) + GetBytes(results.MasksOfCorners) +
    GetBytes(results.HitsOfCorners) + GetBytes(results.PacketOfCorners.Triangle);
}
} // namespace

TEST(PacketKernels, GiveTheSameBitsWithAllInstructions)
{
  Random random(11);
  for (int i = 0; i < 20000; ++i)
  {
    const KernelInput input(random);
    const std::string expected = Compute(lms3dGetPacketKernels(0), input);
    for (int k = 1; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      ASSERT_TRUE(Compute(lms3dGetPacketKernels(k), input) == expected)
        << lms3dGetPacketKernels(k).Name << ", input " << i;
    }
  }
}

TEST(PacketKernels, NeverContradictInSinglePrecision)
{
  Random random(13);
  int sure = 0;
  int different = 0;
  for (int i = 0; i < 40000; ++i)
  {
    KernelInput input(random);
    if (i % 2 != 0)
    {
      input.GrazeCorner(random);
    }
    const NarrowResults expected = ComputeNarrow(lms3dGetPacketKernels(0), input);
    sure += expected.TileMasks.Covered != 0 && expected.Masks.Changed != 0 ? 1 : 0;
    for (int k = 1; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      const NarrowResults results = ComputeNarrow(lms3dGetPacketKernels(k), input);
      ASSERT_TRUE(GetPrepared(results) == GetPrepared(expected) && Allow(results, expected) &&
        Allow(expected, results) && AgreeOnRanges(results, expected))
        << lms3dGetPacketKernels(k).Name << ", input " << i;
      different += GetDecided(results) != GetDecided(expected) ? 1 : 0;
    }
  }
  EXPECT_GT(sure, 100);
  if (lms3dGetNumberOfPacketKernels() > 1)
  {
    EXPECT_GT(different, 100) << "the inputs do not come near to the bounds";
  }
}

/// All sets but the first have fused multiply-add.
TEST(PacketKernels, DecideTheSameInSinglePrecisionWithFusedProducts)
{
  if (lms3dGetNumberOfPacketKernels() < 3)
  {
    GTEST_SKIP() << "needs a processor with AVX-512";
  }
  Random random(13);
  for (int i = 0; i < 20000; ++i)
  {
    const KernelInput input(random);
    const NarrowResults expected = ComputeNarrow(lms3dGetPacketKernels(1), input);
    for (int k = 2; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      const NarrowResults results = ComputeNarrow(lms3dGetPacketKernels(k), input);
      ASSERT_TRUE(GetDecided(results) == GetDecided(expected))
        << lms3dGetPacketKernels(k).Name << ", input " << i;
    }
  }
}
