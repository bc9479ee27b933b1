// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Each triangle is in one box of Embree's tree and in one part of one cluster, and inside of
 * them.
 */
#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dBoxedTriangles.h"
#include "Casting/lms3dTriangleClusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
bool Contains(const lms3dNormalizedBox& box, const lms3dTriangleMesh& mesh, std::size_t triangle,
  const lms3dNormalization& normalization)
{
  bool isInside = true;
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = normalization.NormalizeCoordinate(mesh.GetCorner(triangle, corner), axis);
      isInside = isInside && x > box.Low[axis] + 1e-6 && x < box.High[axis] - 1e-6;
    }
  }
  return isInside;
}

// Returns how many boxes there are.
std::size_t ExpectEachInOneBox(
  const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded)
{
  const lms3dNormalization normalization(mesh, excluded);
  const lms3dBoxedTriangles boxes(mesh, normalization, excluded);
  std::vector<int> times(mesh.GetNumberOfTriangles(), 0);
  for (std::uint32_t i = 0; i < boxes.GetCount(); ++i)
  {
    const lms3dBoxedTriangles::Range range = boxes.Get(i);
    for (std::uint32_t k = 0; k < range.Count; ++k)
    {
      ++times.at(range.First + k);
      EXPECT_TRUE(Contains(boxes.GetBox(i), mesh, range.First + k, normalization));
    }
  }
  for (std::uint32_t i = 0; i < times.size(); ++i)
  {
    EXPECT_EQ(times[i], std::binary_search(excluded.begin(), excluded.end(), i) ? 0 : 1) << i;
  }
  return boxes.GetCount();
}

void ExpectEachInOneCluster(const lms3dTriangleMesh& mesh)
{
  const lms3dNormalization normalization(mesh);
  const lms3dTriangleClusters clusters(mesh, normalization);
  std::vector<int> times(mesh.GetNumberOfTriangles(), 0);
  for (std::size_t i = 0; i < clusters.GetCount(); ++i)
  {
    clusters.ForEachPart(i,
      [&](const lms3dTriangleClusters::Group& part)
      {
        for (std::uint32_t k = 0; k < part.Count; ++k)
        {
          const std::uint32_t triangle = clusters.GetTriangles()[part.First + k];
          ++times.at(triangle);
          EXPECT_TRUE(Contains(part.Box, mesh, triangle, normalization));
          EXPECT_TRUE(Contains(clusters.GetCluster(i).Box, mesh, triangle, normalization));
        }
      });
  }
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
}

lms3dTriangleMesh MakeSoup(int count)
{
  Random random(41);
  std::vector<std::array<Vector, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    const Vector a = random.Get(0.0, 10.0) * random.GetDirection();
    const double size = std::pow(10.0, random.Get(-3.0, 1.0));
    triangles.push_back({ a, a + size * random.GetDirection(), a + size * random.GetDirection() });
  }
  return MakeMesh(triangles);
}
} // namespace

TEST(BoxedTriangles, OfSquaresArePairs)
{
  const lms3dTriangleMesh mesh = MakeCube(7);
  EXPECT_EQ(ExpectEachInOneBox(mesh, {}), mesh.GetNumberOfTriangles() / 2);
  ExpectEachInOneCluster(mesh);
}

TEST(BoxedTriangles, FarFromEachOtherAreAlone)
{
  for (int count : { 1, 2, 3, 20000 })
  {
    const lms3dTriangleMesh mesh = MakeSoup(count);
    EXPECT_GT(ExpectEachInOneBox(mesh, {}), mesh.GetNumberOfTriangles() * 9 / 10);
    ExpectEachInOneCluster(mesh);
  }
}

TEST(BoxedTriangles, LeaveOutOutliers)
{
  EXPECT_EQ(ExpectEachInOneBox(MakeCube(3), { 0, 5, 6, 107 }), 104u);
}
