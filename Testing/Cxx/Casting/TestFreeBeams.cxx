// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Beams that start at points of their own get the triangle, and the bits of the range, that
 * they get in a packet with one origin.
 */
#include "Casting/FreeFixtures.h"
#include "Casting/MethodFixtures.h"
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double Infinity = lms3dBeamPacket::NoRange;
constexpr int Size = lms3dBeamPacket::Size;

/// The result of one beam.
struct Hit
{
  std::int32_t Triangle;
  double Range;
};

bool operator==(const Hit& a, const Hit& b)
{
  return a.Triangle == b.Triangle && a.Range == b.Range;
}

Hit GetHit(const lms3dBeamPacket& packet, int beam)
{
  return { packet.Triangle[beam], packet.Range[beam] };
}

void ExpectSame(const Hit& hit, const Hit& expected, const char* what, int beam)
{
  EXPECT_TRUE(hit == expected) << what << ", beam " << beam << ": triangle " << hit.Triangle
                               << " at " << hit.Range << ", expected " << expected.Triangle
                               << " at " << expected.Range;
}

// What a caster gives to one beam on its own in the first step.
Hit FindAlone(
  const lms3dRayCaster& caster, const lms3dFreePacket& packet, int beam, double maximumRange)
{
  const lms3dRayOrigin origin = GetRayOrigin(packet, beam, maximumRange);
  lms3dBeamPacket lonely = MakeLonelyPacket(packet, beam);
  caster.FindNearest(origin, &lonely, 1);
  caster.ComputeRanges(origin, &lonely, 1);
  return GetHit(lonely, beam);
}

// The same in both steps.
Hit CastAlone(
  const lms3dRayCaster& caster, const lms3dFreePacket& packet, int beam, double maximumRange)
{
  lms3dBeamPacket lonely = MakeLonelyPacket(packet, beam);
  caster.Cast(GetRayOrigin(packet, beam, maximumRange), &lonely, 1);
  return lonely.Triangle[beam] == lms3dBeamPacket::NoTriangle
    ? Hit{ lms3dBeamPacket::NoTriangle, lms3dBeamPacket::NoRange }
    : GetHit(lonely, beam);
}

/// Casts packets and holds each beam against a cast of its own.
class Comparison
{
public:
  explicit Comparison(const lms3dRayCaster& caster)
    : Caster(caster)
  {
  }

  void Compare(const std::vector<lms3dFreePacket>& packets, double maximumRange)
  {
    const int count = static_cast<int>(packets.size());
    std::vector<lms3dFreePacket> nearest = packets;
    this->Caster.FindNearestFree(maximumRange, nearest.data(), count);
    std::vector<lms3dFreePacket> refined = packets;
    this->Caster.CastFree(maximumRange, refined.data(), count);
    for (int i = 0; i < count; ++i)
    {
      for (int beam = 0; beam < Size; ++beam)
      {
        if ((packets[i].Active >> beam) & 1u)
        {
          ExpectSame(GetHit(nearest[i], beam),
            FindAlone(this->Caster, packets[i], beam, maximumRange), "nearest", beam);
          const Hit expected = CastAlone(this->Caster, packets[i], beam, maximumRange);
          ExpectSame(GetHit(refined[i], beam), expected, "refined", beam);
          this->Hits += expected.Triangle != lms3dBeamPacket::NoTriangle;
          ++this->Beams;
        }
      }
    }
  }

  int Hits = 0;
  int Beams = 0;

private:
  const lms3dRayCaster& Caster;
};

std::vector<lms3dFreePacket> MakePackets(
  const lms3dTriangleMesh& mesh, Starts starts, Aims aims, int count, Random& random)
{
  std::vector<lms3dFreePacket> packets(
    std::max(1, count / static_cast<int>(std::min<std::size_t>(Fewer, 10))));
  for (lms3dFreePacket& packet : packets)
  {
    FillFreePacket(mesh, starts, aims, random, packet);
    packet.Active = random.GetBits() % 2 ? 0xffffu : random.GetBits() & 0xffffu;
  }
  return packets;
}

// Casts beams of all kinds without a limit, and with the ranges of some beams as the limit.
void CompareAll(
  int method, const lms3dTriangleMesh& mesh, int packets, Aims aims = Aims::Everywhere)
{
  const std::unique_ptr<lms3dRayCaster> caster = lms3dRayCaster::New(method, mesh);
  Random random(7);
  int hits = 0;
  int beams = 0;
  for (Starts starts : { Starts::Inside, Starts::OnTriangles, Starts::Footprint, Starts::Mixed })
  {
    if (starts == Starts::OnTriangles && aims == Aims::Faces)
    {
      continue;
    }
    SCOPED_TRACE(static_cast<int>(starts));
    std::vector<lms3dFreePacket> some = MakePackets(mesh, starts, aims, packets, random);
    Comparison comparison(*caster);
    comparison.Compare(some, Infinity);
    hits += comparison.Hits;
    beams += comparison.Beams;
    caster->CastFree(Infinity, some.data(), static_cast<int>(some.size()));
    some.resize(std::min<std::size_t>(some.size(), 10));
    for (const lms3dFreePacket& packet : std::vector<lms3dFreePacket>(some))
    {
      const double range = packet.Range[random.GetBits() % Size];
      if (packet.Active == 0xffffu && std::isfinite(range))
      {
        comparison.Compare(some, range);
        comparison.Compare(some, std::nextafter(range, 0.0));
      }
    }
  }
  EXPECT_GT(hits, beams / 16);
}
} // namespace

TEST(FreeBeams, GetTheBitsOfOneOriginInTheRoom)
{
  CompareAll(lms3dRayCaster::EXACT, MakeMesh(ReadRoom()), 80);
}

TEST(FreeBeams, GetTheBitsOfOneOriginAtEdgesAndVertices)
{
  CompareAll(lms3dRayCaster::EXACT, MakeIcosphere(4), 80);
  CompareAll(lms3dRayCaster::EXACT, MakeCube(8), 80);
  CompareAll(lms3dRayCaster::EXACT, MakeBlocks(), 80);
}

TEST(FreeBeams, GetTheBitsOfOneOriginOnBadTriangles)
{
  CompareAll(lms3dRayCaster::EXACT, MakeNeedleWall(1e6), 10);
  CompareAll(lms3dRayCaster::EXACT, MakeTJunction(), 20);
}

TEST(FreeBeams, GetTheBitsOfOneOriginFarFromTheOriginOfTheWorld)
{
  for (double scale : { 1e-100, 1e-3, 1.0, 1e3, 1e100 })
  {
    SCOPED_TRACE(scale);
    const double offset = 1e6 * scale;
    CompareAll(
      lms3dRayCaster::EXACT, Move(MakeIcosphere(3), scale, { offset, -offset, 0.3 * offset }), 40);
  }
}

TEST(FreeBeams, GetTheBitsOfOneOriginBesideOutliers)
{
  lms3dTriangleMesh mesh = MakeIcosphere(3);
  Append(MakeMesh(
           { { Vector{ -1e5, -1e5, -0.9 }, Vector{ 1e5, -1e5, -0.9 }, Vector{ 0.0, 1e5, -0.9 } } }),
    mesh);
  CompareAll(lms3dRayCaster::EXACT, mesh, 80);
}

TEST(FreeBeams, FillWhatTheyNeedThemselves)
{
  const lms3dTriangleMesh mesh = MakeIcosphere(3);
  const std::unique_ptr<lms3dRayCaster> caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, mesh);
  Random random(8);
  lms3dFreePacket packet;
  FillFreePacket(mesh, Starts::Inside, Aims::Everywhere, random, packet);
  packet.Active = 0;
  caster->CastFree(Infinity, &packet, 1);
  caster->CastFree(Infinity, &packet, 0);
  packet.Active = 1;
  std::fill_n(packet.Triangle, Size, 123456);
  std::fill_n(packet.NarrowDirection[0], 3 * Size, 0.0f);
  lms3dBeamPacket lonely = MakeLonelyPacket(packet, 0);
  caster->Cast(GetRayOrigin(packet, 0, Infinity), &lonely, 1);
  caster->CastFree(Infinity, &packet, 1);
  EXPECT_TRUE(GetHit(packet, 0) == GetHit(lonely, 0));
}

class EachFreeMethod : public testing::TestWithParam<int>
{
};

// Single precision may choose either triangle at an edge, and hit the face on which it starts.
TEST_P(EachFreeMethod, GivesFreeBeamsWhatOneOriginGives)
{
  const int method = GetParam();
  CompareAll(
    method, MakeIcosphere(2), 15, method == lms3dRayCaster::FAST ? Aims::Faces : Aims::Everywhere);
}

INSTANTIATE_TEST_SUITE_P(FreeBeams, EachFreeMethod,
  testing::Range(0, lms3dRayCaster::GetNumberOfMethods()), GetMethodName);
