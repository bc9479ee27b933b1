// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts of a scan that cannot see the scene, against each single beam.
 */
#include "Casting/lms3dGridCone.h"
#include "Device/lms3dScanGeometry.h"
#include "Fixtures/CasterFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Side = lms3dBeamGrid::Side;

// The largest product of the cone's axis with a beam of the rectangle.
double GetLargestProduct(const lms3dCone& cone, const lms3dScanGeometry& geometry,
  const lms3dBeamDirections& directions, const lms3dPacketRectangle& rectangle)
{
  const int endTurn =
    std::min(rectangle.FirstTurn + Side * rectangle.Rows, geometry.GetNumberOfTurns());
  const int endBeam =
    std::min(rectangle.FirstBeam + Side * rectangle.Columns, geometry.GetNumberOfBeams());
  double largest = -INFINITY;
  for (int turn = rectangle.FirstTurn; turn < endTurn; ++turn)
  {
    for (int beam = rectangle.FirstBeam; beam < endBeam; ++beam)
    {
      const Vector d = directions.GetDirection(turn, beam);
      largest = std::max(largest, d[0] * cone.Axis[0] + d[1] * cone.Axis[1] + d[2] * cone.Axis[2]);
    }
  }
  return largest;
}
} // namespace

TEST(GridCone, ARectangleIsOutsideIfAllItsBeamsAre)
{
  Random random(23);
  const double alpha[2] = { -90.0, 90.0 };
  const double beta[2] = { 20.0, 311.0 };
  const lms3dScanGeometry geometry(alpha, 181, beta, 291);
  int outside = 0;
  int inside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector orientation = { random.Get(-180.0, 180.0), random.Get(-180.0, 180.0),
      random.Get(-180.0, 180.0) };
    const Vector position = { 1.0, 2.0, 3.0 };
    const lms3dBeamDirections directions(
      geometry, lms3dPose::FromOrientation(position.data(), orientation.data()));
    const lms3dBeamGrid grid = { geometry.GetNumberOfTurns(), geometry.GetNumberOfBeams(),
      &directions.GetFanAxis(0), geometry.GetBetaStep(), geometry.GetAlphaCosines().data(),
      geometry.GetAlphaSines().data(), directions.GetUp() };
    const double distance = std::pow(10.0, random.Get(-3.0, 6.0));
    const Vector axis = distance * random.GetDirection();
    const lms3dCone cone = { { axis[0], axis[1], axis[2] }, distance * random.Get(0.0, 1.0) };
    const lms3dPacketRectangle rectangle = { Side * static_cast<int>(random.GetBits() % 72),
      Side * static_cast<int>(random.GetBits() % 45), 1 + static_cast<int>(random.GetBits() % 4),
      1 + static_cast<int>(random.GetBits() % 16) };

    const double largest = GetLargestProduct(cone, geometry, directions, rectangle);
    if (std::abs(largest - cone.Minimum) > 1e-12 * distance)
    {
      const bool isOutside = lms3dIsOutside(cone, grid, rectangle);
      ASSERT_EQ(isOutside, largest < cone.Minimum);
      (isOutside ? outside : inside) += 1;
    }
    // The cone of a close scene has all directions.
    const lms3dCone all = { { axis[0], axis[1], axis[2] }, -INFINITY };
    ASSERT_FALSE(lms3dIsOutside(all, grid, rectangle));
  }
  EXPECT_GT(outside, 1000);
  EXPECT_GT(inside, 1000);
}
