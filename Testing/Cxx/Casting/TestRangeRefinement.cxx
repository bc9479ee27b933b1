// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges of beams whose triangles are known do not depend on which other triangles other
 * beams hit, although the planes of triangles are kept.
 */
#include "Fixtures/VectorFixtures.h"

#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
constexpr lms3dRayOrigin Origin = { { 0.1, 0.2, 0.3 }, std::numeric_limits<double>::infinity() };
constexpr int Triangles = 4096;

// Triangles at random. The planes of some pass through the sensor within rounding.
lms3dTriangleMesh MakeTriangles(Random& random)
{
  lms3dTriangleMesh mesh;
  for (std::uint32_t i = 0; i < Triangles; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const bool isNear = i % 5 == 0;
      mesh.Points.push_back({ random.Get(-5.0, 5.0), random.Get(-5.0, 5.0),
        isNear ? Origin.Position[2] + random.Get(-1e-15, 1e-15) : random.Get(-5.0, 5.0) });
    }
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}

// The beams hit the triangles that `getTriangle` returns; it need not be true.
template <typename GetTriangle>
std::vector<lms3dBeamPacket> MakePackets(int count, Random& random, const GetTriangle& getTriangle)
{
  std::vector<lms3dBeamPacket> packets(count);
  int number = 0;
  for (lms3dBeamPacket& packet : packets)
  {
    packet.Active = (1u << Size) - 1u;
    for (int i = 0; i < Size; ++i)
    {
      const Vector direction = random.GetDirection();
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.Direction[axis][i] = direction[axis];
      }
      packet.Range[i] = 1.0;
      packet.Triangle[i] = getTriangle(number++);
    }
  }
  return packets;
}

// The range of a beam, from the plane of its triangle alone.
double GetRange(const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin,
  const lms3dBeamPacket& packet, int beam)
{
  const lms3dCorners corners = lms3dGetCorners(mesh, packet.Triangle[beam]);
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const lms3dDoubleDoublePlane plane =
    kernels.MakeDoubleDoublePlane(corners.data(), origin.Position);
  double ranges[Size];
  if (lms3dIsNearPlane(corners, origin.Position, plane))
  {
    lms3dIntersectNearPlane(corners, origin.Position, packet, ranges);
  }
  else
  {
    kernels.IntersectDoubleDoublePlane(plane, packet, ranges);
  }
  return ranges[beam];
}

void ExpectRangesOfEachTriangle(const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin,
  const std::vector<lms3dBeamPacket>& hits, const std::vector<lms3dBeamPacket>& refined)
{
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    for (int beam = 0; beam < Size; ++beam)
    {
      if (hits[i].Triangle[beam] == lms3dBeamPacket::NoTriangle)
      {
        ASSERT_EQ(refined[i].Triangle[beam], lms3dBeamPacket::NoTriangle);
        continue;
      }
      const double range = GetRange(mesh, origin, hits[i], beam);
      const bool isHit = range > 0.0;
      ASSERT_EQ(refined[i].Range[beam], isHit ? range : lms3dBeamPacket::NoRange);
      ASSERT_EQ(
        refined[i].Triangle[beam], isHit ? hits[i].Triangle[beam] : lms3dBeamPacket::NoTriangle);
    }
  }
}

void ExpectRangesOfEachTriangle(
  const lms3dTriangleMesh& mesh, const std::vector<lms3dBeamPacket>& hits)
{
  std::vector<lms3dBeamPacket> refined = hits;
  const lms3dRangeRefinement refinement(mesh);
  refinement.Refine(Origin, refined.data(), static_cast<int>(refined.size()));
  ExpectRangesOfEachTriangle(mesh, Origin, hits, refined);
}
} // namespace

TEST(RangeRefinement, TakesAnyNumberOfTriangles)
{
  Random random(21);
  const lms3dTriangleMesh mesh = MakeTriangles(random);
  for (int triangles = 1; triangles <= 40; ++triangles)
  {
    SCOPED_TRACE(triangles);
    ExpectRangesOfEachTriangle(
      mesh, MakePackets(3, random, [&](int i) { return (i * 7) % triangles - (i % 5 == 0); }));
  }
}

TEST(RangeRefinement, TakesManyTrianglesInAPacket)
{
  Random random(25);
  const lms3dTriangleMesh mesh = MakeTriangles(random);
  // Without planes through the sensor, which are intersected one by one. Some share a slot, some
  // are new.
  for (int triangles : { 2, 3, 5, 8, 9, 16, 800 })
  {
    SCOPED_TRACE(triangles);
    ExpectRangesOfEachTriangle(mesh,
      MakePackets(100, random,
        [&](int i)
        {
          const int group = static_cast<int>(random.GetBits() % triangles);
          const bool isElsewhere = i % 7 == 0;
          return i % 11 == 0 ? -1 : (5 * group + 1 + (isElsewhere ? 1025 : 0)) % 4095;
        }));
  }
}

TEST(RangeRefinement, KeepsPlanesApartThatShareASlot)
{
  Random random(22);
  const lms3dTriangleMesh mesh = MakeTriangles(random);
  for (int stride : { 64, 128, 256, 512, 1024, 2048 })
  {
    SCOPED_TRACE(stride);
    ExpectRangesOfEachTriangle(mesh,
      MakePackets(
        20, random, [&](int i) { return (i % 3 == 0 ? i / 16 : i * stride) % Triangles; }));
  }
}

TEST(RangeRefinement, TakesAnyTriangles)
{
  Random random(23);
  const lms3dTriangleMesh mesh = MakeTriangles(random);
  ExpectRangesOfEachTriangle(mesh,
    MakePackets(200, random, [&](int) { return static_cast<int>(random.GetBits() % Triangles); }));
  ExpectRangesOfEachTriangle(
    mesh, MakePackets(3, random, [](int) { return lms3dBeamPacket::NoTriangle; }));
}

TEST(RangeRefinement, KeepsPlanesOfOneOriginAlone)
{
  Random random(24);
  const lms3dTriangleMesh mesh = MakeTriangles(random);
  const lms3dRangeRefinement refinement(mesh);
  const std::vector<lms3dBeamPacket> hits =
    MakePackets(50, random, [&](int) { return static_cast<int>(random.GetBits() % Triangles); });
  for (double x : { 0.0, 0.0, 0.1, 0.1, 0.0, 0.2 })
  {
    for (double limit : { 1.0, 1e9 })
    {
      SCOPED_TRACE(x);
      const lms3dRayOrigin origin = { { x, 0.2, 0.3 }, limit };
      std::vector<lms3dBeamPacket> expected = hits;
      const lms3dRangeRefinement fresh(mesh);
      fresh.Refine(origin, expected.data(), static_cast<int>(expected.size()));
      std::vector<lms3dBeamPacket> refined = hits;
      for (lms3dBeamPacket& packet : refined)
      {
        refinement.Refine(origin, &packet, 1);
      }
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        for (int beam = 0; beam < Size; ++beam)
        {
          ASSERT_EQ(refined[i].Range[beam], expected[i].Range[beam]);
          ASSERT_EQ(refined[i].Triangle[beam], expected[i].Triangle[beam]);
        }
      }
      if (limit > 1.0)
      {
        ExpectRangesOfEachTriangle(mesh, origin, hits, refined);
      }
    }
  }
}
