// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dTriangleDistance.h"
#include "LocalMap/Borders/lms3dMinimumLinkPath.h"
#include "LocalMap/Bounded/lms3dSortedSearch.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"
#include "LocalMap/Patches/lms3dPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{
lms3dScanGeometry MakeGeometry(int beams, int turns)
{
  const double alpha[2] = { -90.0, 90.0 };
  const double beta[2] = { 0.0, 360.0 };
  return { alpha, beams, beta, turns };
}

/// A sphere of beams that all return at one range.
struct Ball
{
  Ball(int beams, int turns, double range)
    : Geometry(MakeGeometry(beams, turns))
  {
    const std::vector<double> ranges(static_cast<std::size_t>(beams) * turns, range);
    std::vector<int> ids(ranges.size());
    std::iota(ids.begin(), ids.end(), 0);
    this->Grid.Build(this->Geometry, ranges.data(), ids.data(), beams * turns);
    this->Joins.Find(this->Grid, 0.1);
  }

  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
};
} // namespace

TEST(MinimumLinkPath, IsOneArcIfOneArcPassesAllGates)
{
  std::vector<lms3dMinimumLinkPath::Gate> gates;
  for (int i = -20; i <= 20; ++i)
  {
    // Gates around the arc in the plane y = z / 7, with the left to the north.
    const double x = std::cos(0.01 * i);
    const double y = -std::sin(0.01 * i);
    const double z = y / 7.0;
    gates.push_back({ { x, y, z + 0.004 }, { x, y, z - 0.003 }, 0.1, 0.9, 0.5 });
  }
  const lms3dVector start = { std::cos(-0.21), -std::sin(-0.21), -std::sin(-0.21) / 7.0 };
  const lms3dVector end = { std::cos(0.21), -std::sin(0.21), -std::sin(0.21) / 7.0 };
  EXPECT_TRUE(lms3dMinimumLinkPath(gates).Straighten(start, end).empty());

  // A bump forces two bends or three, all within the gates' parts.
  gates[20].Low = 0.0;
  gates[20].High = 0.05;
  const auto line = lms3dMinimumLinkPath(gates).Straighten(start, end);
  EXPECT_GE(line.size(), 1u);
  EXPECT_LE(line.size(), 3u);
  for (const lms3dMinimumLinkPath::Vertex& vertex : line)
  {
    EXPECT_GE(vertex.At, gates[vertex.Gate].Low);
    EXPECT_LE(vertex.At, gates[vertex.Gate].High);
  }
}

TEST(MinimumLinkPath, ClosesAroundABeamWithThreeVerticesOrMore)
{
  std::vector<lms3dMinimumLinkPath::Gate> gates;
  const lms3dVector beam = { 1.0, 0.0, 0.0 };
  // Up, left, down and right as the sensor sees them: counter-clockwise.
  for (const lms3dVector& other : { lms3dVector{ 1.0, 0.0, 0.1 }, lms3dVector{ 1.0, 0.1, 0.0 },
         lms3dVector{ 1.0, 0.0, -0.1 }, lms3dVector{ 1.0, -0.1, 0.0 } })
  {
    gates.push_back({ beam, other, 0.1, 0.9, 0.5 });
  }
  EXPECT_GE(lms3dMinimumLinkPath(gates).StraightenClosed().size(), 3u);
}

TEST(PlaneFit, FindsThePlaneOfReturns)
{
  const Ball ball(31, 24, 2.0);
  const lms3dBeamSphere sphere(ball.Grid, ball.Joins);
  lms3dPlaneFit single;
  const lms3dBeamSphere::GridIndex index = sphere.GetIndex(5, 12);
  single.Add(sphere, index);
  // One return: the plane that faces the sensor.
  const lms3dPlane plane = single.GetPlane();
  const lms3dVector direction = sphere.GetDirection(index);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(plane.Q[axis], direction[axis] / 2.0, 1e-5);
  }
  EXPECT_NEAR(plane.GetInverseRange(direction), 0.5, 1e-12);

  // Three returns: their own plane.
  lms3dPlaneFit three;
  for (lms3dBeamSphere::GridIndex each : { index, index + 1, sphere.GetIndex(6, 12) })
  {
    three.Add(sphere, each);
  }
  for (lms3dBeamSphere::GridIndex each : { index, index + 1, sphere.GetIndex(6, 12) })
  {
    EXPECT_NEAR(three.GetPlane().GetInverseRange(sphere.GetDirection(each)), 0.5, 1e-8);
  }
}

TEST(TriangleRasterizer, HitsEachBeamOnceOrOnASharedEdge)
{
  // An octahedron around the sensor: its edges run along beams, its corners are beams and poles.
  const Ball ball(37, 36, 1.0);
  const lms3dBeamSphere sphere(ball.Grid, ball.Joins);
  std::vector<int> met(sphere.GetSize(), 0);
  for (double x : { -1.0, 1.0 })
  {
    for (double y : { -1.0, 1.0 })
    {
      for (double z : { -1.0, 1.0 })
      {
        lms3dVector corners[3] = { { x, 0, 0 }, { 0, y, 0 }, { 0, 0, z } };
        if (x * y * z > 0.0)
        {
          std::swap(corners[0], corners[1]);
        }
        const lms3dTriangleRasterizer beams(sphere, lms3dTriangleCorner(corners[0]),
          lms3dTriangleCorner(corners[1]), lms3dTriangleCorner(corners[2]));
        beams.ForEachColumn(
          [&](int column, int first, int last)
          {
            for (int row = first; row <= last; ++row)
            {
              ++met[sphere.GetIndex(column, row)];
            }
          });
      }
    }
  }
  for (lms3dBeamSphere::GridIndex index = 0; index < sphere.GetSize(); ++index)
  {
    EXPECT_GE(met[index], 1) << "row " << sphere.GetRow(index) << " of " << sphere.GetColumn(index);
    const lms3dVector direction = sphere.GetDirection(index);
    const bool isInside =
      std::all_of(direction.begin(), direction.end(), [](double x) { return std::abs(x) > 1e-9; });
    EXPECT_TRUE(!isInside || met[index] == 1);
  }
}

TEST(BeamSphere, SurroundsEveryReturnByAHalo)
{
  const double alpha[2] = { -10.0, 10.0 };
  const double beta[2] = { 30.0, 40.0 };
  const lms3dScanGeometry geometry(alpha, 2, beta, 2);
  const std::vector<double> ranges(4, 3.0);
  const std::vector<int> ids = { 0, 1, 2, 3 };
  lms3dRangeGrid grid;
  grid.Build(geometry, ranges.data(), ids.data(), 4);
  lms3dRangeJoins joins;
  joins.Find(grid, 0.1);
  const lms3dBeamSphere sphere(grid, joins);
  EXPECT_EQ(sphere.GetNumberOfReturns(), 4);
  for (lms3dBeamSphere::GridIndex index = 0; index < sphere.GetSize(); ++index)
  {
    const int row = sphere.GetRow(index);
    if (sphere.HasReturn(index))
    {
      EXPECT_GT(row, 0);
      EXPECT_LT(row, sphere.GetNumberOfRows() - 1);
    }
    const lms3dVector right =
      sphere.GetDirection(sphere.GetNeighbor(index, lms3dBeamSphere::Right));
    EXPECT_GE(lms3dDot(sphere.GetDirection(index), right), -0.5 - 1e-9) << "120 degrees at most";
  }
}

TEST(BeamSphere, FindsTheRowOfATangentToWithinOneRow)
{
  const Ball ball(181, 8, 1.0);
  const lms3dBeamSphere sphere(ball.Grid, ball.Joins);
  for (int row = 0; row < sphere.GetNumberOfRows(); ++row)
  {
    EXPECT_NEAR(sphere.GetRowNear(sphere.GetTangents()[row]), row, 1) << row;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sphere.GetRowNear(-infinity), 0);
  EXPECT_EQ(sphere.GetRowNear(infinity), sphere.GetNumberOfRows() - 1);
}

TEST(BeamSphere, RefusesMoreDirectionsThanItCanNumber)
{
  EXPECT_NO_THROW(lms3dBeamSphere::CheckSize(363, 362));
  EXPECT_NO_THROW(lms3dBeamSphere::CheckSize(1, lms3dBeamSphere::MaximumSize));
  EXPECT_THROW(lms3dBeamSphere::CheckSize(1 << 14, 1 << 14), std::runtime_error);
  // The product exceeds 32 bits, and a scan may have as many beams.
  EXPECT_THROW(lms3dBeamSphere::CheckSize(46343, 46342), std::runtime_error);
  EXPECT_THROW(
    lms3dBeamSphere::CheckSize(std::int64_t(1) << 31, std::int64_t(1) << 31), std::runtime_error);
  // Each direction has up to eight vertices at borders.
  EXPECT_LE(8 * std::int64_t(lms3dBeamSphere::MaximumSize),
    std::int64_t(std::numeric_limits<std::int32_t>::max()));
}

TEST(RangeGrid, LimitsALengthToTheLargestRange)
{
  const Ball ball(5, 8, 2.0);
  EXPECT_EQ(ball.Grid.LimitToLargestRange(0.5), 0.5);
  EXPECT_EQ(ball.Grid.LimitToLargestRange(2.0), 2.0);
  EXPECT_EQ(ball.Grid.LimitToLargestRange(3.0), 2.0);
}

TEST(SortedSearch, FindsTheSameFromEachStart)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values = { -infinity, infinity };
  for (int i = 0; i < 20; ++i)
  {
    values.insert(values.end() - 1, 2, i);
  }
  for (double value : { -infinity, -1.0, 0.0, 7.0, 7.5, 19.0, 25.0, infinity })
  {
    const auto isBefore = [value](double other) { return other < value; };
    const int expected =
      static_cast<int>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
    for (int near = -2; near < static_cast<int>(values.size()) + 3; ++near)
    {
      EXPECT_EQ(lms3dFindEndOf(values, near, isBefore), expected) << value << " from " << near;
    }
    using Limits = std::numeric_limits<int>;
    EXPECT_EQ(lms3dFindEndOf(values, Limits::min(), isBefore), expected) << value;
    EXPECT_EQ(lms3dFindEndOf(values, Limits::max(), isBefore), expected) << value;
  }
  EXPECT_EQ(lms3dFindEndOf({}, 0, [](double) { return true; }), 0);
}

TEST(TriangleDistance, IsTheDistanceToTheNearestPoint)
{
  const lms3dVector a = { 0, 0, 0 };
  const lms3dVector b = { 4, 0, 0 };
  const lms3dVector c = { 0, 3, 0 };
  EXPECT_DOUBLE_EQ(lms3dGetDistance({ 1, 1, -2 }, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(lms3dGetDistance({ 1, -3, 4 }, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(lms3dGetDistance({ 7, 0, 4 }, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(lms3dGetDistance({ 4, 3, 0 }, a, b, c), 12.0 / 5.0);
}
