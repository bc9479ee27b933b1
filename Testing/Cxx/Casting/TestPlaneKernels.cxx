// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kernels that take a plane for each beam give the bits of those that take one for all beams, with
 * all instruction sets.
 */
#include "Fixtures/BeamFixtures.h"
#include "Fixtures/VectorFixtures.h"

#include "Casting/lms3dBitMask.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

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
