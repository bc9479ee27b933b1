// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the sums of squares that the surface fit makes small.
 */
#include "LocalMap/SurfaceFitFixture.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
std::vector<lms3dTriangleSums> GetSums(
  const lms3dBeamDemands& demands, const lms3dVertexStars& stars)
{
  std::vector<lms3dTriangleSums> sums;
  for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
  {
    const lms3dVertexStars::Vertex& a = stars.GetVertex(triangle.Corners[0]);
    const lms3dVertexStars::Vertex& b = stars.GetVertex(triangle.Corners[1]);
    const lms3dVertexStars::Vertex& c = stars.GetVertex(triangle.Corners[2]);
    const lms3dTriangleBeams beams(demands.GetSphere(), { &a.Corner, &b.Corner, &c.Corner });
    sums.emplace_back(demands, beams, std::array<double, 3>{ a.Inverse, b.Inverse, c.Inverse });
  }
  return sums;
}

double GetSum(const std::vector<lms3dTriangleSums>& sums, const lms3dVertexStars& stars)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const auto& [a, b, c] = stars.GetTriangles()[i].Corners;
    sum += sums[i].GetSum(
      { stars.GetVertex(a).Inverse, stars.GetVertex(b).Inverse, stars.GetVertex(c).Inverse });
  }
  return sum;
}
} // namespace

// Its corners lie in one plane with the sensor.
TEST_F(SurfaceFit, CountsNoBeamOfAFlatTriangle)
{
  const lms3dBeamDemands demands(this->Sphere, this->Patches, 0.2);
  const lms3dTriangleCorner a({ 1.0, 0.0, 0.0 });
  const lms3dTriangleCorner b({ 0.8, 0.6, 0.0 });
  const lms3dTriangleCorner c({ 0.6, 0.8, 0.0 });
  const lms3dTriangleBeams beams(this->Sphere, { &a, &b, &c });
  const lms3dTriangleSums sums(demands, beams, { 0.5, 0.5, 0.5 });
  EXPECT_EQ(sums.GetSum({ 1.0, 1.0, 1.0 }), 0.0);
  EXPECT_EQ(sums.GetLargestShare(0), 0.0);
}

// Vertices that move back leave their neighbours where they fitted together. In one of these scans,
// the second fit would enlarge the sum.
TEST_F(SurfaceFit, NeverEnlargesTheSumOfSquares)
{
  constexpr double Bound = 0.06;
  constexpr int FewBeams = 32;
  const RoundMap map(Radius);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-(Bound - 0.025), Bound - 0.025);
  for (int trial = 0; trial < 60; ++trial)
  {
    const BallScan scan([&](int, int) { return Radius - 0.025 + 0.9 * noise(random); }, FewBeams);
    const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
    lms3dPatches patches;
    patches.Patches.resize(1);
    patches.Labels.assign(sphere.GetSize(), 0);
    const lms3dBeamDemands demands(sphere, patches, Bound);
    const lms3dBorderShortcuts borders(sphere, patches, Bound);
    lms3dVertexStars stars(map.Get());
    const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
    for (int fit = 0; fit < 2; ++fit)
    {
      const std::vector<lms3dTriangleSums> sums = GetSums(demands, stars);
      const double before = GetSum(sums, stars);
      lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
      EXPECT_LE(GetSum(sums, stars), before) << trial;
    }
  }
}
