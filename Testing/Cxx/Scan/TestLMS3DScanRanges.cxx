// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges that vtkLMS3DScanFilter measures, against geometry and an independent caster.
 */
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Every triangle, Moeller and Trumbore's test in extended precision: nothing shared with the
// filter.
double CastByBruteForce(vtkPolyData* scene, const Point& origin, const Point& direction)
{
  using Real = long double;
  using Vector = std::array<Real, 3>;
  const auto subtract = [](const Point& p, const Point& q) -> Vector {
    return { Real(p[0]) - q[0], Real(p[1]) - q[1], Real(p[2]) - q[2] };
  };
  const auto cross = [](const Vector& p, const Vector& q) -> Vector {
    return { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] };
  };
  const auto dot = [](const Vector& p, const Vector& q)
  { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };

  const Vector d = { direction[0], direction[1], direction[2] };
  Real nearest = std::numeric_limits<Real>::infinity();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    scene->GetCellPoints(cell, corners);
    Point a, b, c;
    scene->GetPoint(corners->GetId(0), a.data());
    scene->GetPoint(corners->GetId(1), b.data());
    scene->GetPoint(corners->GetId(2), c.data());
    const Vector e1 = subtract(b, a);
    const Vector e2 = subtract(c, a);
    const Vector p = cross(d, e2);
    const Real determinant = dot(e1, p);
    if (determinant == 0)
    {
      continue;
    }
    const Vector s = subtract(origin, a);
    const Real u = dot(s, p) / determinant;
    const Vector q = cross(s, e1);
    const Real v = dot(d, q) / determinant;
    const Real t = dot(e2, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0)
    {
      nearest = std::min(nearest, t);
    }
  }
  return static_cast<double>(nearest);
}

class EachMethod : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(EachMethod, ReturnsTheRadiusInAClosedBall)
{
  constexpr double radius = 3.0;
  vtkSmartPointer<vtkPolyData> ball = MakeBall(radius);
  auto scan = MakeScan(ball);
  scan->SetIntersectionMethod(GetParam());
  scan->Update();

  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * 360);
  const double inradius = GetInradius(ball);
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_GE(GetRange(scan, i), inradius * (1 - 1e-14));
    ASSERT_LE(GetRange(scan, i), radius * (1 + 1e-14));
  }
}

TEST_P(EachMethod, MeasuresAPlaneAsTrigonometryDoes)
{
  constexpr double depth = 1.5;
  auto scan = MakeScan(MakeFloor(1000.0, -depth));
  scan->SetIntersectionMethod(GetParam());
  scan->SetAlphaRange(-90.0, -2.0);
  scan->SetAlphaResolution(89);
  scan->Update();

  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 89 * 360);
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double alpha = GetArray(scan, "Alpha")->GetTuple1(i);
    const double expected = depth / std::sin(vtkMath::RadiansFromDegrees(-alpha));
    ASSERT_NEAR(GetRange(scan, i), expected, 1e-14 * expected) << "alpha " << alpha;
  }
}

TEST_P(EachMethod, AgreesWithAnIndependentBruteForceCaster)
{
  vtkSmartPointer<vtkPolyData> room = ReadRoom();
  ASSERT_EQ(room->GetNumberOfCells(), 804);
  const Point origin = { 0.31, -0.17, 1.05 };
  auto scan = MakeScan(room);
  scan->SetIntersectionMethod(GetParam());
  scan->SetPosition(origin.data());
  SetGrid(scan, 61, 72);
  scan->Update();

  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double alpha = GetArray(scan, "Alpha")->GetTuple1(i);
    const double beta = GetArray(scan, "Beta")->GetTuple1(i);
    const double expected = CastByBruteForce(room, origin, GetPaperDirection(alpha, beta));
    // Directions differ in their last bit, which a grazing angle magnifies.
    ASSERT_NEAR(GetRange(scan, i), expected, 1e-12 * expected) << alpha << ", " << beta;
  }
}

TEST_P(EachMethod, LosesNoBeamOfATurnedSensor)
{
  auto scan = MakeScan(MakeBall(2.0, 24));
  scan->SetIntersectionMethod(GetParam());
  SetGrid(scan, 91, 90);
  for (double x : { 0.0, 45.0, 90.0, 180.0 })
  {
    for (double y : { 0.0, 30.0, 90.0, 270.0 })
    {
      scan->SetOrientation(x, y, 60.0);
      scan->Update();
      EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 91 * 90) << x << ", " << y;
    }
  }
}

TEST_P(EachMethod, SeesASceneFromVeryFar)
{
  auto scan = MakeScan(MakeBall(1.0));
  scan->SetIntersectionMethod(GetParam());
  scan->SetPosition(-1e6, 0.0, 0.0);
  scan->SetMaximumRange(2e6);
  scan->SetAlphaRange(-1e-5, 1e-5);
  scan->SetAlphaResolution(11);
  scan->SetBetaRange(-1e-5, 1e-5);
  scan->SetBetaResolution(11);
  scan->Update();
  // 1e-5 degrees are 0.17 m at this distance, well within the ball.
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 121);
  EXPECT_NEAR(GetRange(scan, 60), 1e6 - 1.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanFilter, EachMethod,
  testing::Values(vtkLMS3DScanFilter::EXACT, vtkLMS3DScanFilter::FAST),
  [](const auto& method) { return method.param == vtkLMS3DScanFilter::EXACT ? "Exact" : "Fast"; });

TEST(LMS3DScanFilter, LosesNoBeamOnEdgesAndVertices)
{
  // A ball of four meridians and five circles of latitude, poles counted: from its middle, beams at
  // multiples of 90 degrees run along the meridians, those at 0, 45 and 90 degrees of elevation
  // through the vertices.
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(4);
  source->SetPhiResolution(5);
  source->Update();
  auto scan = MakeScan(source->GetOutput());
  for (int resolution : { 5, 9, 17, 33, 361 })
  {
    SetGrid(scan, resolution, 360);
    scan->Update();
    EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 360 * resolution);
  }
}
