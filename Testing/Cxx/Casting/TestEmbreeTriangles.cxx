// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Packets of beams in all directions: some lead away from the triangles, or start far off.
 */
#include "Casting/lms3dEmbreeTriangles.h"
#include "Casting/lms3dPacketBeams.h"
#include "Fixtures/MeshFixtures.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
constexpr double Unlimited = std::numeric_limits<double>::infinity();

// How far the origin of the coordinates is from a ray.
double GetDistance(const Vector& start, const Vector& direction)
{
  const double along = std::max(0.0, -lms3dDot(start, direction));
  return GetLength(start + along * direction);
}

// Every other beam is aimed at a ball around the origin, the others lead anywhere.
void SetDirection(int beam, const Vector& start, Random& random, lms3dBeamPacket& packet)
{
  const Vector aim = 0.9 * random.GetDirection();
  const Vector direction = beam % 2 == 0 ? Normalize(aim - start) : random.GetDirection();
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.Direction[axis][beam] = direction[axis];
  }
}

/// Casts packets at a ball of radius 1.
class EmbreeTriangles : public testing::TestWithParam<double>
{
protected:
  // The triangles lie between these radii.
  static constexpr double Inner = 0.95;
  static constexpr double Outer = 1.0;

  void ExpectHits(const Vector& start, int beam, const lms3dBeamPacket& packet)
  {
    const double distance = GetDistance(start, lms3dGetDirection(packet, beam));
    const bool isHit = packet.Triangle[beam] != lms3dBeamPacket::NoTriangle;
    if (distance < Inner || distance > Outer + 1e-5)
    {
      EXPECT_EQ(isHit, distance < Inner) << "beam " << beam << " passes at " << distance;
    }
  }

  const double Range = this->GetParam();
  Random Numbers{ 5 };
  const lms3dTriangleMesh Mesh = MakeIcosphere(3);
  const lms3dEmbreeTriangles Triangles{ Mesh, Mesh.Triangles, [](double) { return true; } };
};
} // namespace

TEST_P(EmbreeTriangles, AreHitByTheBeamsTowardsThem)
{
  for (int i = 0; i < 500; ++i)
  {
    const Vector start = this->Range * this->Numbers.GetDirection();
    lms3dBeamPacket packet;
    packet.Active = 0xffff;
    for (int beam = 0; beam < Size; ++beam)
    {
      SetDirection(beam, start, this->Numbers, packet);
    }
    lms3dGetPacketKernels().Free.NarrowDirections(packet);
    this->Triangles.Cast({ { start[0], start[1], start[2] }, Unlimited }, &packet, 1);
    for (int beam = 0; beam < Size; ++beam)
    {
      this->ExpectHits(start, beam, packet);
    }
  }
}

TEST_P(EmbreeTriangles, AreHitByTheBeamsTowardsThemFromAnywhere)
{
  for (int i = 0; i < 500; ++i)
  {
    lms3dFreePacket packet;
    packet.Active = 0xffff;
    for (int beam = 0; beam < Size; ++beam)
    {
      const Vector start = this->Range * this->Numbers.GetDirection();
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.Origin[axis][beam] = start[axis];
      }
      SetDirection(beam, start, this->Numbers, packet);
    }
    this->Triangles.CastFree(Unlimited, &packet, 1);
    for (int beam = 0; beam < Size; ++beam)
    {
      this->ExpectHits(lms3dGetOrigin(packet, beam), beam, packet);
    }
  }
}

TEST(FarRays, HitNothing)
{
  const lms3dTriangleMesh mesh = MakeIcosphere(1);
  const lms3dEmbreeTriangles triangles(mesh, mesh.Triangles, [](double) { return true; });
  lms3dFreePacket packet;
  packet.Active = 0xffff;
  Random random(6);
  for (int beam = 0; beam < Size; ++beam)
  {
    const Vector start = std::pow(10.0, 19 + 15 * beam) * random.GetDirection();
    const Vector direction = random.GetDirection();
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][beam] = start[axis];
      packet.Direction[axis][beam] = direction[axis];
    }
  }
  triangles.CastFree(Unlimited, &packet, 1);
  for (int beam = 0; beam < Size; ++beam)
  {
    EXPECT_EQ(packet.Triangle[beam], lms3dBeamPacket::NoTriangle) << beam;
  }
}

// Metres from the centre.
INSTANTIATE_TEST_SUITE_P(From, EmbreeTriangles, testing::Values(0.3, 3.0, 100.0, 1e4, 1e9));
