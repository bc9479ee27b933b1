// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that the surface fit leaves borders at depth steps at their returns, and which borders are
 * certain.
 */
#include "LocalMap/SurfaceFitFixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{
/// The metres by which borders at a depth step may be away from their returns.
constexpr double Tolerance = 0.045;

/// The number of edges at the height of the sensor with a support.
int CountBorders(const lms3dVertexStars& stars, const lms3dBorderShortcuts& borders,
  lms3dBorderShortcuts::Support support)
{
  int count = 0;
  for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const lms3dVertexStars::Vertex& from = stars.GetVertex(triangle.Corners[corner]);
      const lms3dVertexStars::Vertex& to = stars.GetVertex(triangle.Corners[(corner + 1) % 3]);
      const bool isBorder =
        std::abs(from.Corner.Position[2]) < 1e-9 && std::abs(to.Corner.Position[2]) < 1e-9;
      count += isBorder && borders.GetSupportAtDepthSteps(from, to) == support ? 1 : 0;
    }
  }
  return count;
}
} // namespace

// The lower half of a ball ends before a wider one. With its vertices on the ball, its border runs
// a bit inside; vertices that fit the returns lie too far outside for a border at a depth step.
TEST_F(SurfaceFit, KeepsBordersAtDepthStepsSupported)
{
  using Support = lms3dBorderShortcuts::Support;
  constexpr double Bound = 0.2;
  constexpr int EvenBeams = 90;
  const BallScan scan(
    [](int beam, int) { return beam < EvenBeams / 2 ? Radius : 2.0 * Radius; }, EvenBeams);
  const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
  lms3dPatches patches;
  patches.Patches.resize(2);
  patches.Labels.assign(sphere.GetSize(), 0);
  lms3dPatches onlyLower = patches;
  for (int turn = 0; turn < Turns; ++turn)
  {
    for (int row = EvenBeams / 2; row < EvenBeams; ++row)
    {
      patches.Labels[sphere.GetIndex(turn, row)] = 1;
      onlyLower.Labels[sphere.GetIndex(turn, row)] = -1;
    }
  }
  const RoundMap map(Radius, 4);
  const lms3dBorderShortcuts judge(sphere, patches, Tolerance);
  int unsupported[2] = { 0, 0 };
  for (bool hasStep : { false, true })
  {
    const lms3dPatches& used = hasStep ? patches : onlyLower;
    const lms3dBeamDemands demands(sphere, used, Bound);
    const lms3dBorderShortcuts borders(sphere, used, Tolerance);
    lms3dVertexStars stars(map.Get());
    const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
    EXPECT_EQ(CountBorders(stars, judge, Support::Supported), 16);
    lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
    EXPECT_TRUE(stars.GetVertex(FindVertex(stars, { 0.0, 0.0, -1.0 })).HasMoved);
    unsupported[hasStep] = CountBorders(stars, judge, Support::Unsupported);
  }
  EXPECT_GT(unsupported[0], 0);
  EXPECT_EQ(unsupported[1], 0);
}

// The rows beside such a vertex are not certain.
TEST_F(SurfaceFit, FindsNoCertainBorderIfATangentIsNotFinite)
{
  using Support = lms3dBorderShortcuts::Support;
  const lms3dBorderShortcuts borders(this->Sphere, this->Patches, Tolerance);
  const auto getSupport = [&](const lms3dVector& a, const lms3dVector& b)
  {
    const auto makeVertex = [](const lms3dVector& position)
    {
      return lms3dVertexStars::Vertex{ lms3dTriangleCorner(position), 1.0 / Radius, false, false,
        false, {} };
    };
    return borders.GetSupportAtDepthSteps(makeVertex(a), makeVertex(b));
  };
  // Between two columns.
  const lms3dVector finite = lms3dNormalize({ 1.0, -0.02, 0.3 });
  EXPECT_EQ(getSupport(lms3dNormalize({ 1.0, -0.04, 0.3 }), finite), Support::NoDepthStep);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const lms3dVector& other :
    { lms3dVector{ 1.0, -0.04, nan }, lms3dVector{ 1e-200, -4e-202, 1.0 } })
  {
    EXPECT_EQ(getSupport(other, finite), Support::Unsupported);
    EXPECT_EQ(getSupport(finite, other), Support::Unsupported);
  }
}
