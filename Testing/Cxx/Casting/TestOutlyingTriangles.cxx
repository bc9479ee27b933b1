// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Huge triangles in a mesh of many small ones. The search for them and for the size of the
 * rest is divided into tasks of 4,096 triangles.
 */
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/MeshFixtures.h"

#include "Casting/lms3dNormalization.h"
#include "Casting/lms3dOutlyingTriangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
/// Twice in the same task, on both sides of its end, in a later one, and at the end of the mesh.
const std::vector<std::uint32_t> Numbers = { 0, 17, 4095, 4096, 13000, 20479 };

constexpr double Size = 1e4;

/// A ball of radius 1 with triangles far outside, below, before and above it.
lms3dTriangleMesh MakeBallWithOutliers()
{
  lms3dTriangleMesh mesh = MakeIcosphere(5);
  double height = -0.95;
  for (std::uint32_t triangle : Numbers)
  {
    const auto first = static_cast<std::uint32_t>(mesh.Points.size());
    mesh.Points.push_back({ -Size, -Size, height });
    mesh.Points.push_back({ Size, -Size, height });
    mesh.Points.push_back({ 0.0, Size, height + 0.3 });
    mesh.Triangles[triangle] = { first, first + 1, first + 2 };
    height += 0.35;
  }
  return mesh;
}
} // namespace

TEST(OutlyingTriangles, AreFoundInEveryTask)
{
  const lms3dTriangleMesh mesh = MakeBallWithOutliers();
  ASSERT_EQ(mesh.GetNumberOfTriangles(), 20480u);
  EXPECT_EQ(lms3dFindOutlyingTriangles(mesh), Numbers);
  EXPECT_EQ(lms3dFindOtherTriangles(mesh, Numbers).size(), 20480u - Numbers.size());
  EXPECT_TRUE(lms3dFindOutlyingTriangles(MakeIcosphere(5)).empty());
}

TEST(OutlyingTriangles, AreLeftOutOfTheSize)
{
  const lms3dTriangleMesh mesh = MakeBallWithOutliers();
  EXPECT_NEAR(lms3dNormalization(mesh, Numbers).GetDiagonal(), 2.0 * std::sqrt(3.0), 0.01);
  for (std::size_t i = 0; i < Numbers.size(); ++i)
  {
    std::vector<std::uint32_t> allButOne = Numbers;
    allButOne.erase(allButOne.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_GT(lms3dNormalization(mesh, allButOne).GetDiagonal(), Size) << Numbers[i];
  }
}

TEST(OutlyingTriangles, AreHitWhereTheyAre)
{
  const Target target(MakeBallWithOutliers());
  for (const Vector& sensor : { Vector{ 0.1, 0.2, -0.3 }, Vector{ 0.0, 0.0, 5.0 } })
  {
    Tally sum = JudgeAllAround(target, sensor, 2000 / Fewer);
    sum += JudgeTriangles(target, sensor, 200 / Fewer);
    ExpectExact(sum);
    EXPECT_GT(sum.Hits, sum.Beams / 4) << sum;
  }
  Random random(12);
  for (std::uint32_t triangle : Numbers)
  {
    ExpectExact(Judge(target, {}, target.MakeBeamsAt(triangle, {}, random)));
  }
}
