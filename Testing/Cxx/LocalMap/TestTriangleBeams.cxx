// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the beams that hit a triangle, and whether they stay within the bound.
 */
#include "LocalMap/Bounded/lms3dTriangleBeams.h"
#include "LocalMap/SurfaceFitFixture.h"

#include "Geometry/lms3dAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{
/// Triangles of several sizes that face the sensor.
class TriangleBeams : public SurfaceFit
{
protected:
  using GridIndex = lms3dBeamSphere::GridIndex;

  void SetUp() override
  {
    for (double size : { 0.05, 0.3, 0.9 })
    {
      for (int i = 0; i < 20; ++i)
      {
        const lms3dVector center = this->GetRandomDirection();
        const lms3dVector a = this->GetCornerNear(center, size);
        const lms3dVector b = this->GetCornerNear(center, size);
        const lms3dVector c = this->GetCornerNear(center, size);
        const bool isTurned = lms3dDot(lms3dCross(c, b), a) < 0.0;
        this->Triangles.push_back({ lms3dTriangleCorner(a), lms3dTriangleCorner(isTurned ? c : b),
          lms3dTriangleCorner(isTurned ? b : c) });
      }
    }
  }

  static lms3dTriangleBeams::Corners GetCorners(const std::array<lms3dTriangleCorner, 3>& triangle)
  {
    return { &triangle[0], &triangle[1], &triangle[2] };
  }

  /// How far inside of all edges a beam passes, as the product with their normals.
  static double GetDepth(
    const std::array<lms3dTriangleCorner, 3>& triangle, const lms3dVector& direction)
  {
    double depth = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      const lms3dVector edge = lms3dCross(triangle[(i + 1) % 3].Position, triangle[i].Position);
      depth = std::min(depth, lms3dDot(edge, direction) / lms3dGetLength(edge));
    }
    return depth;
  }

  lms3dVector GetRandomDirection()
  {
    std::normal_distribution<double> normal;
    return lms3dNormalize({ normal(this->Random), normal(this->Random), normal(this->Random) });
  }

  lms3dVector GetCornerNear(const lms3dVector& center, double size)
  {
    return lms3dNormalize(lms3dAdd(center, lms3dScale(this->GetRandomDirection(), size)));
  }

  std::mt19937 Random{ 7 };
  std::vector<std::array<lms3dTriangleCorner, 3>> Triangles;
};
} // namespace

TEST_F(TriangleBeams, AreThoseInsideOfItsEdges)
{
  constexpr double Rounding = 1e-8;
  for (const std::array<lms3dTriangleCorner, 3>& triangle : this->Triangles)
  {
    std::set<GridIndex> found;
    const lms3dTriangleBeams beams(this->Sphere, GetCorners(triangle));
    for (const lms3dTriangleBeams::Span& span : beams.GetSpans())
    {
      for (int row = span.First; row <= span.Last; ++row)
      {
        EXPECT_TRUE(found.insert(this->Sphere.GetIndex(span.Column, row)).second);
      }
    }
    for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
    {
      const double depth = GetDepth(triangle, this->Sphere.GetDirection(index));
      if (std::abs(depth) > Rounding)
      {
        EXPECT_EQ(found.count(index) > 0, depth > 0.0) << index;
      }
    }
  }
}

// The share of a corner is 1 there and 0 on the opposite edge, so the plane passes the corners.
TEST_F(TriangleBeams, HavePlanesThroughTheCorners)
{
  const std::array<double, 3> inverses = { 0.4, 0.5, 0.7 };
  for (const std::array<lms3dTriangleCorner, 3>& triangle : this->Triangles)
  {
    const lms3dTriangleBeams beams(this->Sphere, GetCorners(triangle));
    EXPECT_TRUE(beams.FacesSensor());
    const lms3dVector plane = beams.GetPlane(inverses);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(lms3dDot(plane, triangle[i].Position), inverses[i], 1e-9);
      EXPECT_NEAR(lms3dDot(beams.GetShares()[i], triangle[(i + 1) % 3].Position), 0.0, 1e-9);
    }
  }
}

// Corners move until single beams leave the bound. Missing beams, and returns without a patch,
// demand nothing.
TEST_F(TriangleBeams, AreWithinTheBoundIfEachBeamIs)
{
  constexpr double Bound = 0.2;
  std::bernoulli_distribution isSpoiled(0.1);
  const BallScan scan([&](int, int) { return isSpoiled(this->Random) ? 0.0 : Radius; });
  const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
  for (std::int32_t& label : this->Patches.Labels)
  {
    label = isSpoiled(this->Random) ? lms3dPatches::None : label;
  }
  const lms3dBeamDemands demands(sphere, this->Patches, Bound);
  std::uniform_real_distribution<double> range(Radius - 0.3, Radius + 0.3);
  int within = 0;
  int beyond = 0;
  for (const std::array<lms3dTriangleCorner, 3>& triangle : this->Triangles)
  {
    const lms3dTriangleBeams beams(sphere, GetCorners(triangle));
    for (int trial = 0; trial < 10; ++trial)
    {
      const std::array<double, 3> inverses = { 1.0 / range(this->Random), 1.0 / range(this->Random),
        1.0 / range(this->Random) };
      const lms3dVector plane = beams.GetPlane(inverses);
      double largest = 0.0;
      for (const lms3dTriangleBeams::Span& span : beams.GetSpans())
      {
        for (int row = span.First; row <= span.Last; ++row)
        {
          const GridIndex index = sphere.GetIndex(span.Column, row);
          const double met = 1.0 / lms3dDot(plane, sphere.GetDirection(index));
          const bool demandsNothing = !sphere.HasReturn(index) || this->Patches.Labels[index] < 0;
          largest = demandsNothing ? largest : std::max(largest, std::abs(met - Radius));
        }
      }
      if (std::abs(largest - Bound) > 1e-6)
      {
        EXPECT_EQ(beams.AreWithinBound(demands, inverses), largest < Bound);
        ++(largest < Bound ? within : beyond);
      }
    }
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(beyond, 100);
}

// The returns lie on a plane a distance behind the plane of the triangle. The sum is the area
// between the beams, in radians squared, times the square of the distance, however beams meet it.
TEST_F(TriangleBeams, GiveTheAreaTimesTheSquareOfADistance)
{
  constexpr double Distance = 0.002;
  constexpr int FineBeams = 721;
  const lms3dVector center = { 1.0, 0.0, 0.0 };
  for (const lms3dVector& towards :
    { lms3dVector{ 1.0, 0.0, 0.0 }, lms3dVector{ 1.0, 0.7, 0.0 }, lms3dVector{ 1.0, 0.6, -1.1 } })
  {
    const lms3dVector normal = lms3dNormalize(towards);
    const double offset = 2.0 * lms3dDot(normal, center);
    const BallScan directions([](int, int) { return Radius; }, FineBeams);
    const lms3dBeamSphere empty(directions.Grid, directions.Joins);
    const BallScan scan(
      [&](int beam, int turn)
      {
        const double cosine = lms3dDot(normal, empty.GetDirection(empty.GetIndex(turn, beam)));
        return cosine > 0.1 ? (offset + Distance) / cosine : 0.0;
      },
      FineBeams);
    const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
    lms3dPatches patches;
    patches.Patches.resize(1);
    patches.Labels.assign(sphere.GetSize(), 0);
    const lms3dBeamDemands demands(sphere, patches, 0.2);
    const std::array<lms3dVector, 3> directionsOfCorners = { lms3dNormalize({ 1.0, 0.4, 0.4 }),
      lms3dNormalize({ 1.0, -0.5, 0.3 }), lms3dNormalize({ 1.0, 0.1, -0.4 }) };
    std::array<lms3dVector, 3> points;
    std::array<double, 3> inverses;
    for (int i = 0; i < 3; ++i)
    {
      inverses[i] = lms3dDot(normal, directionsOfCorners[i]) / offset;
      points[i] = lms3dScale(directionsOfCorners[i], 1.0 / inverses[i]);
    }
    const lms3dTriangleCorner a(directionsOfCorners[0]);
    const lms3dTriangleCorner b(directionsOfCorners[1]);
    const lms3dTriangleCorner c(directionsOfCorners[2]);
    const bool isTurned = lms3dDot(lms3dCross(c.Position, b.Position), a.Position) < 0.0;
    const lms3dTriangleBeams beams(sphere, { &a, isTurned ? &c : &b, isTurned ? &b : &c });
    if (isTurned)
    {
      std::swap(inverses[1], inverses[2]);
    }
    const double area = 0.5 *
      lms3dGetLength(
        lms3dCross(lms3dSubtract(points[1], points[0]), lms3dSubtract(points[2], points[0])));
    const double step = (180.0 / (FineBeams - 1)) * (360.0 / Turns) * std::pow(lms3dPi / 180.0, 2);
    EXPECT_NEAR(beams.GetSum(demands, inverses) * step, area * Distance * Distance,
      0.03 * area * Distance * Distance);
  }
}
