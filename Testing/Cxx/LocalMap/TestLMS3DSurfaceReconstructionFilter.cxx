// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Plain grids: closed surfaces, their orientation and their normals.
 */
#include "LocalMap/PlainGridFixtures.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace
{
std::array<Point, 3> GetPoints(vtkPolyData* map, vtkIdList* corners)
{
  std::array<Point, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    map->GetPoint(corners->GetId(i), points[i].data());
  }
  return points;
}

void ExpectFacing(vtkPolyData* map, const Point& sensor)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    auto [a, b, c] = GetPoints(map, corners);
    Point normal;
    vtkTriangle::ComputeNormal(a.data(), b.data(), c.data(), normal.data());
    const Point toSensor = { sensor[0] - a[0], sensor[1] - a[1], sensor[2] - a[2] };
    ASSERT_GT(vtkMath::Dot(normal.data(), toSensor.data()), 0.0) << "triangle " << cell;
  }
}
} // namespace

TEST(LMS3DSurfaceReconstructionFilter, ReportsAnErrorOnceForEachChange)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputData(MakeBall(2.0));
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 1);
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 0);
  filter->SetDepthStep(0.2);
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 1);
}

TEST(LMS3DSurfaceReconstructionFilter, ClosesABall)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  vtkPolyData* map = pipeline.Run();
  // Each pole is one vertex, so 359 rings of 360 and two poles.
  EXPECT_EQ(map->GetNumberOfPoints(), 359 * 360 + 2);
  EXPECT_EQ(map->GetNumberOfCells(), 2 * 358 * 360 + 2 * 360);
  const std::set<Edge> edges = GetDirectedEdges(map);
  EXPECT_EQ(CountBoundaryEdges(edges), 0);
  const vtkIdType undirected = static_cast<vtkIdType>(edges.size()) / 2;
  EXPECT_EQ(map->GetNumberOfPoints() - undirected + map->GetNumberOfCells(), 2) << "Euler";
  ExpectFacing(map, { 0.0, 0.0, 0.0 });
}

TEST(LMS3DSurfaceReconstructionFilter, StaysClosedForAnyPoseAndResolution)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetPosition(0.7, -0.3, 0.4);
  pipeline.Scan->SetOrientation(20.0, 40.0, 60.0);
  pipeline.Scan->SetAlphaResolution(31);
  pipeline.Scan->SetBetaResolution(24);
  vtkPolyData* map = pipeline.Run();
  EXPECT_EQ(map->GetNumberOfPoints(), 29 * 24 + 2);
  EXPECT_EQ(CountBoundaryEdges(GetDirectedEdges(map)), 0);
  ExpectFacing(map, { 0.7, -0.3, 0.4 });
}

TEST(LMS3DSurfaceReconstructionFilter, LeavesTheRimOfAPartOpen)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaRange(-30.0, 30.0);
  pipeline.Scan->SetAlphaResolution(7);
  pipeline.Scan->SetBetaRange(0.0, 90.0);
  pipeline.Scan->SetBetaResolution(10);
  vtkPolyData* map = pipeline.Run();
  EXPECT_EQ(map->GetNumberOfPoints(), 70);
  EXPECT_EQ(map->GetNumberOfCells(), 2 * 6 * 9);
  EXPECT_EQ(CountBoundaryEdges(GetDirectedEdges(map)), 2 * 6 + 2 * 9);
}

TEST(LMS3DSurfaceReconstructionFilter, HasRangesAndUnitNormalsTowardsTheSensor)
{
  const Point sensor = { 0.5, 0.0, 0.2 };
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetPosition(sensor.data());
  vtkPolyData* map = pipeline.Run();
  vtkDataArray* normals = map->GetPointData()->GetNormals();
  vtkDataArray* ranges = map->GetPointData()->GetArray("Range");
  ASSERT_NE(normals, nullptr);
  ASSERT_NE(ranges, nullptr);
  EXPECT_EQ(ranges->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    Point p, normal;
    map->GetPoint(i, p.data());
    normals->GetTuple(i, normal.data());
    ASSERT_NEAR(vtkMath::Norm(normal.data()), 1.0, 1e-6);
    // The facets of the ball turn by at most 7.5 degrees, and lean with its triangles.
    const double cosine = -vtkMath::Dot(normal.data(), p.data()) / vtkMath::Norm(p.data());
    ASSERT_GT(cosine, std::cos(vtkMath::RadiansFromDegrees(10.0)));
    ASSERT_NEAR(ranges->GetTuple1(i),
      std::sqrt(vtkMath::Distance2BetweenPoints(p.data(), sensor.data())), 1e-14);
  }
}

TEST(LMS3DSurfaceReconstructionFilter, HasTheMeanNormalsOfItsTriangles)
{
  PlainGridPipeline pipeline(ReadRoom());
  const Point sensor = { 0.3, -0.2, 1.0 };
  pipeline.Scan->SetPosition(sensor.data());
  pipeline.Scan->SetMaximumRange(2.0); // Leaves whole turns, and parts of others, without returns.
  vtkPolyData* map = pipeline.Run();
  std::vector<Point> sums(map->GetNumberOfPoints(), Point{});
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    auto [a, b, c] = GetPoints(map, corners);
    Point normal;
    vtkMath::Subtract(b.data(), a.data(), b.data());
    vtkMath::Subtract(c.data(), a.data(), c.data());
    vtkMath::Cross(b.data(), c.data(), normal.data());
    for (vtkIdType corner : *corners)
    {
      vtkMath::Add(sums[corner].data(), normal.data(), sums[corner].data());
    }
  }
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    Point expected = sums[i], normal, p;
    if (vtkMath::Norm(expected.data()) == 0.0)
    {
      map->GetPoint(i, p.data());
      vtkMath::Subtract(sensor.data(), p.data(), expected.data());
    }
    vtkMath::Normalize(expected.data());
    map->GetPointData()->GetNormals()->GetTuple(i, normal.data());
    ASSERT_GT(vtkMath::Dot(normal.data(), expected.data()), 1.0 - 1e-6) << "point " << i;
  }
}

TEST(LMS3DSurfaceReconstructionFilter, MapsTheRoom)
{
  PlainGridPipeline pipeline(ReadRoom());
  pipeline.Scan->SetPosition(0.3, -0.2, 1.0);
  vtkPolyData* map = pipeline.Run();
  ExpectFacing(map, { 0.3, -0.2, 1.0 });
  // Some cells at the silhouettes of the furniture stay open.
  EXPECT_GT(map->GetNumberOfCells(), 0.97 * 258480);
  EXPECT_LT(map->GetNumberOfCells(), 258480);
}
