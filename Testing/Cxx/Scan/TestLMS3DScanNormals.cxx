// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The normals and the incidence of the returns of a scan.
 */
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"
#include "Scan/LabelledScan.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
// The arrays are in single precision.
constexpr double NormalTolerance = 1e-7;
constexpr double DegreeTolerance = 1e-5;

Point GetTuple(vtkLMS3DScanFilter* scan, const char* name, vtkIdType i)
{
  Point tuple;
  GetArray(scan, name)->GetTuple(i, tuple.data());
  return tuple;
}

/// The unit vector from a return to the sensor.
Vector GetWayToSensor(vtkLMS3DScanFilter* scan, vtkIdType i)
{
  Vector point, position;
  scan->GetOutput()->GetPoint(i, point.data());
  scan->GetPosition(position.data());
  return Normalize(position - point);
}

double GetDegrees(double cosine)
{
  return vtkMath::DegreesFromRadians(std::acos(std::min(1.0, cosine)));
}
} // namespace

TEST(LMS3DScanSurfaceAttributes, IncidenceOnAFloorIsTheAngleFromThePlumbLine)
{
  for (double height : { 1.5, -1.5 })
  {
    auto scan = MakeLabelledScan(MakeFloor(1000.0, -height));
    scan->SetAlphaRange(height > 0.0 ? -90.0 : 2.0, height > 0.0 ? -2.0 : 90.0);
    scan->Update();
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
    for (vtkIdType i = 0; i < 61 * 72; ++i)
    {
      const double alpha = GetArray(scan, "Alpha")->GetTuple1(i);
      ASSERT_NEAR(
        GetArray(scan, "Incidence")->GetTuple1(i), 90.0 - std::abs(alpha), DegreeTolerance);
      ASSERT_EQ(GetTuple(scan, "Normals", i), (Point{ 0.0, 0.0, height > 0.0 ? 1.0 : -1.0 }));
    }
  }
}

TEST(LMS3DScanSurfaceAttributes, InABoxTheLargestComponentOfTheDirectionCounts)
{
  SceneBuilder box;
  box.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  auto scan = MakeLabelledScan(box.GetSurface());
  scan->SetOrientation(10.0, 20.0, 30.0);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
  for (vtkIdType i = 0; i < 61 * 72; ++i)
  {
    const Vector way = GetWayToSensor(scan, i);
    const auto largest = std::max_element(
      way.begin(), way.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    ASSERT_NEAR(
      GetArray(scan, "Incidence")->GetTuple1(i), GetDegrees(std::abs(*largest)), DegreeTolerance);
    const Point normal = GetTuple(scan, "Normals", i);
    ASSERT_NEAR(normal[largest - way.begin()], *largest > 0.0 ? 1.0 : -1.0, NormalTolerance);
  }
}

TEST(LMS3DScanSurfaceAttributes, InABallIncidenceFollowsTheSineRule)
{
  // A triangle spans a degree along one axis and half a degree along the other.
  constexpr double Facet = 0.75;
  constexpr double Offset = 0.6;
  auto scan = MakeLabelledScan(MakeBall(1.0, 360));
  scan->SetPosition(Offset, 0.0, 0.0);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
  for (vtkIdType i = 0; i < 61 * 72; ++i)
  {
    const double cosine = GetWayToSensor(scan, i)[0];
    const double expected =
      vtkMath::DegreesFromRadians(std::asin(Offset * std::sqrt(1.0 - cosine * cosine)));
    ASSERT_NEAR(GetArray(scan, "Incidence")->GetTuple1(i), expected, Facet);
  }
}

TEST(LMS3DScanSurfaceAttributes, NormalsHaveLengthOneAndFaceTheSensorForAnyOrderOfCorners)
{
  auto room = ReadRoom();
  vtkNew<vtkPolyData> reversed;
  reversed->DeepCopy(room);
  for (vtkIdType cell = 0; cell < reversed->GetNumberOfCells(); ++cell)
  {
    reversed->ReverseCell(cell);
  }
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    auto scan = MakeLabelledScan(room);
    auto other = MakeLabelledScan(reversed);
    for (vtkLMS3DScanFilter* filter : { scan.Get(), other.Get() })
    {
      filter->SetIntersectionMethod(method);
      filter->SetPosition(0.3, -0.2, 1.0);
      filter->Update();
    }
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 61 * 72);
    ASSERT_EQ(other->GetOutput()->GetNumberOfPoints(), 61 * 72);
    for (vtkIdType i = 0; i < 61 * 72; ++i)
    {
      const Point normal = GetTuple(scan, "Normals", i);
      ASSERT_LT(GetLength(normal - GetTuple(other, "Normals", i)), NormalTolerance);
      ASSERT_NEAR(GetLength(normal), 1.0, NormalTolerance);
      const double cosine = vtkMath::Dot(normal.data(), GetWayToSensor(scan, i).data());
      ASSERT_GT(cosine, 0.0);
      const double incidence = GetArray(scan, "Incidence")->GetTuple1(i);
      ASSERT_NEAR(std::cos(vtkMath::RadiansFromDegrees(incidence)), cosine, 4 * NormalTolerance);
    }
  }
}

TEST(LMS3DScanSurfaceAttributes, NormalsAreOnTheSideOfTheSensorWithoutRounding)
{
#ifdef __SIZEOF_INT128__
  __extension__ using Integer = __int128;
  // The sensor's coordinates are multiples of this. The corners' are whole numbers.
  constexpr double Unit = 0x1p-43;
  Random random(1);
  int returns = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    Vector corner[3];
    for (Vector& point : corner)
    {
      std::generate(
        point.begin(), point.end(), [&random] { return std::round(random.Get(-500.0, 500.0)); });
    }
    const Vector p = corner[1] - corner[0];
    const Vector q = corner[2] - corner[0];
    Vector normal;
    vtkMath::Cross(p.data(), q.data(), normal.data());
    Vector position = corner[0] + random.Get(0.2, 0.4) * p + random.Get(0.2, 0.4) * q;
    Integer side = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = std::round(position[axis] / Unit) * Unit;
      side += static_cast<Integer>(normal[axis]) *
        (static_cast<Integer>(position[axis] / Unit) -
          static_cast<Integer>(corner[0][axis] / Unit));
    }
    auto scan = MakeLabelledScan(MakePolygon({ corner[0], corner[1], corner[2] }));
    SetGrid(scan, 7, 8);
    scan->SetPosition(position.data());
    scan->Update();
    for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i, ++returns)
    {
      const Point found = GetTuple(scan, "Normals", i);
      ASSERT_EQ(vtkMath::Dot(found.data(), normal.data()) > 0.0, side > 0) << trial;
    }
  }
  EXPECT_GT(returns, 200);
#endif
}

TEST(LMS3DScanSurfaceAttributes, ANeedleHasItsNormal)
{
  // A needle 1 m long and 1e-12 m wide, in the plane z = x far from the origin.
  constexpr double Far = 1000.0;
  const Point a = { Far, -0.5, Far };
  const Point b = { Far, 0.5, Far };
  const Point c = { Far + 0x1p-40, 0.5, Far + 0x1p-40 };
  auto scan = MakeLabelledScan(MakePolygon({ a, b, c }));
  scan->SetPosition(Far, 0.5, Far + 1.0);
  scan->SetAlphaRange(-90.0, -90.0);
  SetGrid(scan, 1, 1);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 1);
  const Point normal = GetTuple(scan, "Normals", 0);
  EXPECT_NEAR(normal[0], -std::sqrt(0.5), NormalTolerance);
  EXPECT_NEAR(normal[1], 0.0, NormalTolerance);
  EXPECT_NEAR(normal[2], std::sqrt(0.5), NormalTolerance);
  EXPECT_NEAR(GetArray(scan, "Incidence")->GetTuple1(0), 45.0, DegreeTolerance);
}
