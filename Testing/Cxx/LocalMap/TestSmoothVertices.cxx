// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks at which vertices a map counts as smooth.
 */
#include "LocalMap/Bounded/lms3dSmoothVertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Bound = 0.01;
constexpr int Few = 11;
constexpr int Many = 12;

struct Verdict
{
  bool IsCurved;
  std::vector<std::uint8_t> AreSmooth;
};

/// A map each of whose triangles is a patch of many returns. All planes are the same.
struct Surface
{
  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c)
  {
    this->Map.Triangles.push_back({ a, b, c });
    this->Map.PatchIds.push_back(this->Map.NumberOfPatches++);
    this->Patches.Patches.emplace_back();
    this->Patches.Patches.back().Plane.Q = { 0.0, 0.0, 1.0 };
    this->Members.push_back(Many);
  }

  void Turn(int patch) { this->Patches.Patches[patch].Plane.Q = { 1.0, 0.0, 0.0 }; }

  Verdict Find(double noise = 0.0) const
  {
    const lms3dVertexStars stars(this->Map);
    const lms3dSmoothVertices smooth(this->Patches, this->Members, this->Map, stars, Bound, noise);
    return { smooth.IsCurved(), smooth.Get() };
  }

  lms3dBoundedMap Map;
  lms3dPatches Patches;
  std::vector<int> Members;
};

/// Six triangles around the vertex 0, so only this vertex is inside.
Surface MakeFan()
{
  Surface fan;
  fan.Map.Points.push_back({ 2.0, 0.0, 0.0 });
  for (int i = 0; i < 6; ++i)
  {
    const double angle = i * Pi / 3.0;
    fan.Map.Points.push_back({ 2.0, -0.1 * std::cos(angle), 0.1 * std::sin(angle) });
  }
  for (std::int32_t i = 0; i < 6; ++i)
  {
    fan.AddTriangle(0, 1 + i, 1 + (i + 1) % 6);
  }
  return fan;
}

/// All six vertices are inside.
Surface MakeOctahedron()
{
  Surface octahedron;
  octahedron.Map.Points = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { -1.0, 0.0, 0.0 },
    { 0.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  for (std::int32_t i = 0; i < 4; ++i)
  {
    octahedron.AddTriangle((i + 1) % 4, i, 4);
    octahedron.AddTriangle(i, (i + 1) % 4, 5);
  }
  return octahedron;
}

std::vector<std::uint8_t> Only(std::int32_t vertex, std::size_t count)
{
  std::vector<std::uint8_t> smooth(count);
  smooth[vertex] = 1;
  return smooth;
}
} // namespace

TEST(SmoothVertices, AreInsideAndHaveSimilarPlanes)
{
  Surface fan = MakeFan();
  EXPECT_EQ(fan.Find().AreSmooth, Only(0, 7));
  fan.Turn(2);
  EXPECT_EQ(fan.Find().AreSmooth, std::vector<std::uint8_t>(7));
}

TEST(SmoothVertices, NeedReliablePlanesWithoutNoise)
{
  Surface fan = MakeFan();
  fan.Members[2] = Few;
  fan.Turn(2);
  EXPECT_FALSE(fan.Find().IsCurved);
  EXPECT_EQ(fan.Find().AreSmooth, std::vector<std::uint8_t>(7));
  EXPECT_EQ(fan.Find(0.1 * Bound).AreSmooth, Only(0, 7));
}

// The triangle 2 joins patches along an offset of 10 cm.
TEST(SmoothVertices, AreNotAtLargeOffsets)
{
  Surface fan = MakeFan();
  fan.Map.PatchIds[2] = lms3dBoundedMap::NoPatch;
  EXPECT_EQ(fan.Find(0.1 * Bound).AreSmooth, Only(0, 7));
  // The shortest edge leads across the offset.
  fan.Map.Points[3] = lms3dScale(lms3dAdd(fan.Map.Points[0], fan.Map.Points[3]), 0.525);
  EXPECT_EQ(fan.Find(0.1 * Bound).AreSmooth, std::vector<std::uint8_t>(7));
}

TEST(SmoothVertices, IgnoreUnreliablePlanesAndOffsetsOnCurvedSurfaces)
{
  Surface octahedron = MakeOctahedron();
  octahedron.Members[2] = Few;
  octahedron.Turn(2);
  octahedron.Map.Points[4] = { 0.0, 0.0, 1.5 };
  octahedron.Map.PatchIds[4] = lms3dBoundedMap::NoPatch;
  const Verdict smooth = octahedron.Find();
  EXPECT_TRUE(smooth.IsCurved);
  EXPECT_EQ(smooth.AreSmooth, std::vector<std::uint8_t>(6, 1));
}

// Half of the vertices are enough.
TEST(SmoothVertices, StaySharpOnCurvedSurfaces)
{
  Surface octahedron = MakeOctahedron();
  octahedron.Turn(0);
  const Verdict smooth = octahedron.Find();
  EXPECT_TRUE(smooth.IsCurved);
  const std::array<std::int32_t, 3>& sharp = octahedron.Map.Triangles[0];
  for (std::int32_t vertex = 0; vertex < 6; ++vertex)
  {
    EXPECT_NE(
      smooth.AreSmooth[vertex] == 1, std::find(sharp.begin(), sharp.end(), vertex) != sharp.end());
  }
  // The triangle opposite to the first one.
  octahedron.Turn(5);
  EXPECT_FALSE(octahedron.Find().IsCurved);
}
