// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that a map is fitted to the returns of a ball around the sensor.
 */
#include "LocalMap/SurfaceFitFixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

// With its vertices on the ball, the map lies inside of the ball everywhere else.
TEST_F(SurfaceFit, PassesBetweenTheReturns)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  const Distances before = this->Measure(stars);
  this->FitAll(0.2, stars);
  const Distances after = this->Measure(stars);
  EXPECT_LT(after.SumOfSquares, 0.2 * before.SumOfSquares);
  EXPECT_LT(after.Largest, before.Largest);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_GT(1.0 / stars.GetVertex(vertex).Inverse, Radius);
    EXPECT_TRUE(stars.GetVertex(vertex).HasMoved);
  }
}

TEST_F(SurfaceFit, KeepsTheBound)
{
  const RoundMap map(Radius);
  const double distance = this->Measure(lms3dVertexStars(map.Get())).Largest;
  // The bound is larger than needed, just enough for the map before the fit, or too small for it.
  for (double share : { 1.5, 1.0001, 0.9, 0.5 })
  {
    // The second map lies on both sides of the ball, and its vertices are nearer to the bound.
    for (double size : { Radius, Radius + 0.9 * distance })
    {
      const RoundMap other(size);
      lms3dVertexStars stars(other.Get());
      const Distances before = this->Measure(stars);
      this->FitAll(share * distance, stars);
      const Distances after = this->Measure(stars);
      EXPECT_LE(after.Largest, std::max(before.Largest, share * distance) + 1e-9) << share;
      EXPECT_LE(after.SumOfSquares, 1.0001 * before.SumOfSquares) << share;
    }
  }
}

// A return in the direction of a vertex is nearly the bound nearer than the ball. So the vertex may
// not move as far as without it.
TEST_F(SurfaceFit, KeepsTheBoundOfASingleReturn)
{
  constexpr double Bound = 0.2;
  const RoundMap map(Radius);
  lms3dVertexStars free(map.Get());
  this->FitAll(Bound, free);
  const std::int32_t vertex = FindVertex(free, { 1.0, 0.0, 0.0 });
  EXPECT_GT(1.0 / free.GetVertex(vertex).Inverse, Radius + 0.1 * Bound);

  const BallScan scan(
    [](int beam, int turn) { return beam == 45 && turn == 0 ? Radius - 0.95 * Bound : Radius; });
  const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
  const lms3dBeamDemands demands(sphere, this->Patches, Bound);
  const lms3dBorderShortcuts borders(sphere, this->Patches, Bound);
  lms3dVertexStars stars(map.Get());
  const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
  lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
  EXPECT_LE(1.0 / stars.GetVertex(vertex).Inverse, Radius + 0.05 * Bound + 1e-9);
}

TEST_F(SurfaceFit, MovesOnlyChosenVertices)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 0);
  isChosen[7] = 1;
  this->Fit(0.2, isChosen, stars);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_EQ(stars.GetVertex(vertex).HasMoved, vertex == 7) << vertex;
  }
}

TEST_F(SurfaceFit, HardlyMovesAMapThatFits)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  this->FitAll(0.2, stars);
  std::vector<double> inverses;
  inverses.reserve(stars.GetNumberOfVertices());
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    inverses.push_back(stars.GetVertex(vertex).Inverse);
  }
  this->FitAll(0.2, stars);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_NEAR(1.0 / stars.GetVertex(vertex).Inverse, 1.0 / inverses[vertex], 0.003) << vertex;
  }
}
