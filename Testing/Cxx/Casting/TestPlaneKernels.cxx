// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kernels that take a plane for each beam give the bits of those that take one for all
 * beams, with all instruction sets.
 */
#include "Fixtures/BeamFixtures.h"
#include "Fixtures/VectorFixtures.h"

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
constexpr double MaximumRange = 10.0;

/// Some hits, with the triangle of each, and where the sensor is.
struct Hits
{
  explicit Hits(Random& random)
    : Origin(random.GetDirection())
  {
    for (auto& triangle : this->Triangles)
    {
      for (Vector& corner : triangle)
      {
        corner = random.Get(0.0, 20.0) * random.GetDirection();
      }
    }
    for (int i = 0; i < Size; ++i)
    {
      const Vector direction = random.GetDirection();
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Packet.Direction[axis][i] = direction[axis];
      }
      this->Packet.Range[i] = random.Get(0.0, 20.0);
      this->Packet.Triangle[i] = i;
    }
  }

  Vector Origin;
  std::array<std::array<Vector, 3>, Size> Triangles;
  lms3dBeamPacket Packet;
};

lms3dBeamPacket StoreOneByOne(const Hits& hits, std::uint32_t beams)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels(0);
  lms3dBeamPacket packet = hits.Packet;
  for (int i = 0; i < Size; ++i)
  {
    if (lms3dHasBit(beams, i))
    {
      const auto& triangle = hits.Triangles[i];
      const double* corners[] = { triangle[0].data(), triangle[1].data(), triangle[2].data() };
      double ranges[Size];
      kernels.IntersectDoubleDoublePlane(
        kernels.MakeDoubleDoublePlane(corners, hits.Origin.data()), packet, ranges);
      kernels.StoreRanges(ranges, i, MaximumRange, packet);
    }
  }
  return packet;
}

lms3dBeamPacket StoreAtOnce(
  const Hits& hits, std::uint32_t beams, const lms3dPacketKernels& kernels)
{
  lms3dPacketCorners corners;
  for (int i = 0; i < Size; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corners.Corner[corner][axis][i] = hits.Triangles[i][corner][axis];
      }
    }
  }
  lms3dPacketPlanes planes;
  kernels.MakeDoubleDoublePlanes(corners, Size, hits.Origin.data(), planes);
  lms3dBeamPacket packet = hits.Packet;
  double ranges[Size];
  kernels.IntersectDoubleDoublePlanes(planes, packet, ranges);
  kernels.StoreRangesOfBeams(ranges, beams, MaximumRange, packet);
  return packet;
}

/// The ranges of one tile whose beams all have one plane.
struct TileRanges
{
  bool AreWithin;
  std::vector<double> Ranges;
};

/// A tile cut off at the grid's end or not, in a grid that is wider.
struct Tile
{
  static constexpr int Stride = 37;

  explicit Tile(Random& random)
    : Turns(1 + static_cast<int>(random.GetBits() % Size))
    , Beams(1 + static_cast<int>(random.GetBits() % Size))
    , Up(random.GetDirection())
  {
    const Vector middle = random.GetDirection();
    for (int i = 0; i < Size; ++i)
    {
      const double elevation = random.Get(-0.3, 0.3);
      this->Cosines[i] = std::cos(elevation);
      this->Sines[i] = std::sin(elevation);
      this->Fans[i] = middle + 0.3 * random.GetDirection();
    }
  }

  TileRanges MakeRanges() const
  {
    return { true, std::vector<double>(static_cast<std::size_t>(Stride) * this->Turns, -7.0) };
  }

  TileRanges Intersect(const lms3dPacketKernels& kernels, const lms3dDoubleDoublePlane& plane,
    const lms3dRangeWindow& within) const
  {
    TileRanges result = this->MakeRanges();
    result.AreWithin = kernels.IntersectTile(plane,
      { this->Cosines.data(), this->Sines.data(), this->Fans.data(), this->Up.data(), this->Turns,
        this->Beams },
      within, result.Ranges.data(), Stride);
    return result;
  }

  // Turn by turn, by packets.
  TileRanges IntersectPackets(
    const lms3dDoubleDoublePlane& plane, const lms3dRangeWindow& within) const
  {
    const lms3dPacketKernels& kernels = lms3dGetPacketKernels(0);
    TileRanges result = this->MakeRanges();
    for (int turn = 0; turn < this->Turns; ++turn)
    {
      double ranges[Size];
      kernels.IntersectDoubleDoublePlane(plane, this->MakePacket(turn), ranges);
      std::copy_n(ranges, this->Beams, result.Ranges.begin() + turn * Stride);
      result.AreWithin &= std::all_of(ranges, ranges + this->Beams,
        [&within](double range)
        { return range > 0.0 && range >= within.Minimum && range <= within.Maximum; });
    }
    return result;
  }

  lms3dBeamPacket MakePacket(int turn) const
  {
    lms3dElevations elevations;
    lms3dFanAxes axes;
    std::copy(this->Cosines.begin(), this->Cosines.end(), elevations.Cosine);
    std::copy(this->Sines.begin(), this->Sines.end(), elevations.Sine);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::fill_n(axes.Horizontal[axis], Size, this->Fans[turn][axis]);
      axes.Up[axis] = this->Up[axis];
    }
    lms3dBeamPacket packet;
    lms3dGetPacketKernels(0).GenerateDirections(elevations, axes, packet);
    return packet;
  }

  int Turns;
  int Beams;
  Vector Up;
  std::array<double, Size> Cosines;
  std::array<double, Size> Sines;
  std::array<Vector, Size> Fans;
};
} // namespace

TEST(PlaneKernels, GiveTheBitsOfOnePlaneForAllBeams)
{
  Random random(31);
  for (int i = 0; i < 2000; ++i)
  {
    const Hits hits(random);
    const std::uint32_t beams = random.GetBits() & 0xffffu;
    const lms3dBeamPacket expected = StoreOneByOne(hits, beams);
    for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      const lms3dPacketKernels& kernels = lms3dGetPacketKernels(k);
      SCOPED_TRACE(kernels.Name);
      const lms3dBeamPacket packet = StoreAtOnce(hits, beams, kernels);
      EXPECT_TRUE(std::equal(packet.Range, packet.Range + Size, expected.Range));
      EXPECT_TRUE(std::equal(packet.Triangle, packet.Triangle + Size, expected.Triangle));
    }
  }
}

// Planes before, behind and beside the sensor, and limits that some ranges exceed, fall short of or
// equal.
TEST(PlaneKernels, GiveTheBitsOfPacketsForATile)
{
  Random random(37);
  int within = 0;
  int beyond = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Tile tile(random);
    const Hits hits(random);
    const auto& triangle = hits.Triangles[0];
    const double* corners[] = { triangle[0].data(), triangle[1].data(), triangle[2].data() };
    const lms3dDoubleDoublePlane plane =
      lms3dGetPacketKernels(0).MakeDoubleDoublePlane(corners, hits.Origin.data());
    const TileRanges all = tile.IntersectPackets(plane, { 0.0, lms3dBeamPacket::NoRange });
    const lms3dRangeWindow limits = { i % 3 == 0 ? all.Ranges[0] : 0.0,
      i % 2 == 0 ? all.Ranges[0] : lms3dBeamPacket::NoRange };
    const TileRanges expected = tile.IntersectPackets(plane, limits);
    (expected.AreWithin ? within : beyond) += 1;
    for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      SCOPED_TRACE(lms3dGetPacketKernels(k).Name);
      const TileRanges ranges = tile.Intersect(lms3dGetPacketKernels(k), plane, limits);
      EXPECT_EQ(ranges.AreWithin, expected.AreWithin);
      EXPECT_EQ(ranges.Ranges, expected.Ranges);
    }
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(beyond, 100);
}

TEST(PlaneKernels, RefineARangeInOneStepAsInTwo)
{
  Random random(41);
  for (int i = 0; i < 2000; ++i)
  {
    Hits hits(random);
    const std::uint32_t bits = i % 4 == 0 ? 0u : random.GetBits();
    for (int beam = 0; beam < Size; ++beam)
    {
      hits.Packet.Triangle[beam] = lms3dHasBit(bits, beam) ? 1 : 0;
    }
    const auto& triangle = hits.Triangles[0];
    const double* corners[] = { triangle[0].data(), triangle[1].data(), triangle[2].data() };
    const lms3dPacketKernels& first = lms3dGetPacketKernels(0);
    const lms3dDoubleDoublePlane plane = first.MakeDoubleDoublePlane(corners, hits.Origin.data());
    double ranges[Size];
    lms3dBeamPacket expected = hits.Packet;
    first.IntersectDoubleDoublePlane(plane, expected, ranges);
    const std::uint32_t measured = first.StoreRanges(ranges, 0, MaximumRange, expected);
    for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
    {
      SCOPED_TRACE(lms3dGetPacketKernels(k).Name);
      lms3dBeamPacket packet = hits.Packet;
      EXPECT_EQ(lms3dGetPacketKernels(k).RefineRanges(plane, 0, MaximumRange, packet), measured);
      EXPECT_TRUE(std::equal(packet.Range, packet.Range + Size, expected.Range));
      EXPECT_TRUE(std::equal(packet.Triangle, packet.Triangle + Size, expected.Triangle));
    }
  }
}
