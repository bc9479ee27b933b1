// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The exact caster below VTK: beams exactly through corners and edges, and along
 * silhouettes.
 */
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
/// All directions whose components are multiples of 1/steps and whose largest component is 1.
std::vector<Beams> MakeGridDirections(int steps)
{
  std::vector<Vector> directions;
  for (int x = -steps; x <= steps; ++x)
  {
    for (int y = -steps; y <= steps; ++y)
    {
      for (int z = -steps; z <= steps; ++z)
      {
        if (std::max({ std::abs(x), std::abs(y), std::abs(z) }) == steps)
        {
          directions.push_back({ double(x) / steps, double(y) / steps, double(z) / steps });
        }
      }
    }
  }
  std::vector<Beams> packets(directions.size() / lms3dBeamPacket::Size);
  for (std::size_t i = 0; i < packets.size() * lms3dBeamPacket::Size; ++i)
  {
    packets[i / lms3dBeamPacket::Size][i % lms3dBeamPacket::Size] = directions[i];
  }
  return packets;
}

Tally JudgeOnGrid(const Target& target, double scale, const Vector& center, int reach)
{
  const std::vector<Beams> packets = MakeGridDirections(8);
  constexpr std::size_t Sensors = Fewer > 1 ? 4 : 30;
  return JudgeEach(Sensors,
    [&](std::size_t number)
    {
      Random random(number);
      Vector sensor;
      for (double& x : sensor)
      {
        x = static_cast<double>(random.GetBits() % (2 * reach - 1)) + 1.0 - reach;
      }
      Tally sum;
      for (const Beams& beams : packets)
      {
        sum += Judge(target, (scale / 8.0) * sensor + center, beams);
      }
      return sum;
    });
}
} // namespace

TEST(ExactRayCasting, LosesNoBeamThroughCornersAndEdgesOfACube)
{
  for (double offset : { 0.0, 0x1p22 })
  {
    for (double scale : { 0x1p-10, 1.0, 0x1p10 })
    {
      const Vector center = { offset, -offset, 0.5 * offset };
      const Target target(Move(MakeCube(8), scale, center));
      const Tally sum = JudgeOnGrid(target, scale, center, 8);
      ExpectExactAndWhole(sum);
    }
  }
}

TEST(ExactRayCasting, SeesBlocksOnItsOwnGrid)
{
  // Beams run along faces, edges and silhouettes; the sensor may stand on a face, or within a
  // block.
  for (double offset : { 0.0, 0x1p22 })
  {
    const Vector center = { offset, -offset, 0.5 * offset };
    const Target target(Move(MakeBlocks(), 1.0, center));
    const Tally sum = JudgeOnGrid(target, 8.0, center, 8);
    EXPECT_GT(sum.Hits, sum.Beams / 4);
    EXPECT_LT(sum.Hits, sum.Beams);
    ExpectExact(sum);
  }
}

TEST(ExactRayCasting, SeesSilhouettesFromOutside)
{
  for (double distance : { 1.1, 3.0, 1e3, 1e7 })
  {
    const Target target(MakeIcosphere(3));
    const Tally sum = JudgeEach(500 / std::min<std::size_t>(Fewer, 10),
      [&](std::size_t number)
      {
        Random random(number);
        const Vector axis = number % 2 ? Vector{ 0.0, 0.0, 1.0 } : random.GetDirection();
        const std::size_t triangle = random.GetBits() % target.GetMesh().GetNumberOfTriangles();
        const Vector sensor = distance * axis;
        return Judge(target, sensor, target.MakeBeamsAt(triangle, sensor, random));
      });
    EXPECT_GT(sum.Hits, sum.Beams / 2);
    ExpectExact(sum);
  }
}

// Packets that do not point at the sphere around the scene are not cast. Of a cube the corners
// alone are on it, and seen from a tangent at a corner, that corner is at the rim.
TEST(ExactRayCasting, HitsTheCornersOnTheSphereThatBoundsTheScene)
{
  Random random(23);
  const Target cube(MakeCube(1));
  const Vector corner = { 1.0, 1.0, 1.0 };
  for (double distance : { 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6 })
  {
    Tally tally;
    for (int i = 0; i < 100; ++i)
    {
      const Vector p = random.GetDirection();
      const Vector tangent = { p[1] - p[2], p[2] - p[0], p[0] - p[1] };
      const Vector sensor = corner + distance * Normalize(tangent);
      Beams beams;
      for (Vector& beam : beams)
      {
        const Vector inwards = { random.Get(), random.Get(), random.Get() };
        beam = Normalize(corner - sensor - std::pow(10.0, random.Get(-16, -9)) * inwards);
      }
      tally += Judge(cube, sensor, beams);
    }
    EXPECT_GT(tally.Hits, 100) << distance;
    ExpectExact(tally);
  }
}
