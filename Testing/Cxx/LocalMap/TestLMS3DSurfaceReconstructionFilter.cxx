// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace
{
struct Pipeline
{
  explicit Pipeline(vtkDataObject* scene)
  {
    this->Scan->SetInputDataObject(scene);
    this->Map->SetInputConnection(this->Scan->GetOutputPort());
    this->Map->SetMaximumError(0.0);
  }

  vtkPolyData* Run()
  {
    this->Map->Update();
    return this->Map->GetOutput();
  }

  vtkNew<vtkLMS3DScanFilter> Scan;
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> Map;
};

using Edge = std::pair<vtkIdType, vtkIdType>;

/// The directed edges of the triangles. Fails the test if an edge occurs twice.
std::set<Edge> GetDirectedEdges(vtkPolyData* map)
{
  std::set<Edge> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    EXPECT_EQ(corners->GetNumberOfIds(), 3);
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge(corners->GetId(i), corners->GetId((i + 1) % 3));
      EXPECT_NE(edge.first, edge.second);
      EXPECT_TRUE(edges.insert(edge).second) << "two triangles turn the same way at an edge";
    }
  }
  return edges;
}

vtkIdType CountBoundaryEdges(const std::set<Edge>& edges)
{
  return std::count_if(edges.begin(), edges.end(),
    [&](const Edge& edge) {
      return edges.count({ edge.second, edge.first }) == 0;
    });
}

/// The largest range difference along a triangle's edge.
double GetLargestStep(vtkPolyData* map)
{
  vtkDataArray* range = map->GetPointData()->GetArray("Range");
  double largest = 0.0;
  for (const Edge& edge : GetDirectedEdges(map))
  {
    largest =
      std::max(largest, std::abs(range->GetTuple1(edge.first) - range->GetTuple1(edge.second)));
  }
  return largest;
}

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

vtkSmartPointer<vtkPolyData> CopyScan(vtkLMS3DScanFilter* scan)
{
  scan->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(scan->GetOutput());
  return copy;
}

void ExpectError(vtkPolyData* scan, const std::string& word)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputDataObject(scan);
  const std::string error = UpdateAndGetError(filter);
  EXPECT_NE(error.find(word), std::string::npos) << error;
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
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
  Pipeline pipeline(MakeBall(2.0));
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
  Pipeline pipeline(MakeBall(2.0));
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
  Pipeline pipeline(MakeBall(2.0));
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
  Pipeline pipeline(MakeBall(2.0));
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
  Pipeline pipeline(ReadRoom());
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

TEST(LMS3DSurfaceReconstructionFilter, NeverCrossesADepthStep)
{
  // A plate one metre in front of a wall.
  const double x = 3.0;
  Pipeline pipeline(Join(MakePolygon({ { x, -9, -9 }, { x, 9, -9 }, { x, 9, 9 }, { x, -9, 9 } }),
    MakePolygon(
      { { x - 1, -0.5, -0.5 }, { x - 1, 0.5, -0.5 }, { x - 1, 0.5, 0.5 }, { x - 1, -0.5, 0.5 } })));
  pipeline.Scan->SetAlphaRange(-40.0, 40.0);
  pipeline.Scan->SetAlphaResolution(161);
  pipeline.Scan->SetBetaRange(-40.0, 40.0);
  pipeline.Scan->SetBetaResolution(161);
  vtkPolyData* map = pipeline.Run();
  EXPECT_EQ(map->GetNumberOfPoints(), 161 * 161);
  EXPECT_LT(GetLargestStep(map), 0.2);
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    map->GetCell(cell)->GetBounds(bounds);
    ASSERT_LT(bounds[1] - bounds[0], 1e-9) << "a triangle lies on the plate or on the wall";
  }

  // A DepthStep above the step bridges it.
  const vtkIdType separate = map->GetNumberOfCells();
  pipeline.Map->SetDepthStep(1.5);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 2 * 160 * 160);
  EXPECT_LT(separate, 2 * 160 * 160);
}

TEST(LMS3DSurfaceReconstructionFilter, KeepsAGrazingFloorWhole)
{
  // Up to 57 m away, where the returns of neighbouring beams are tens of metres apart.
  Pipeline pipeline(MakeFloor(1000.0, -1.0));
  pipeline.Scan->SetAlphaRange(-90.0, -1.0);
  pipeline.Scan->SetAlphaResolution(179);
  vtkPolyData* map = pipeline.Run();
  EXPECT_GT(GetLargestStep(map), 15.0);
  EXPECT_EQ(map->GetNumberOfCells(), 2 * 177 * 360 + 360);
}

TEST(LMS3DSurfaceReconstructionFilter, NeverJoinsAcrossAMiss)
{
  Pipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(19);
  pipeline.Scan->SetBetaResolution(36);
  vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
  // Take the return in the middle of the grid away.
  vtkNew<vtkPolyData> holed;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  holed->SetPoints(points);
  holed->GetPointData()->CopyAllocate(scan->GetPointData());
  holed->GetFieldData()->ShallowCopy(scan->GetFieldData());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    if (i != 18 * 19 + 9)
    {
      const vtkIdType to = points->InsertNextPoint(scan->GetPoint(i));
      holed->GetPointData()->CopyData(scan->GetPointData(), i, to);
    }
  }
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetMaximumError(0.0);
  map->SetInputDataObject(holed);
  map->Update();
  // Each of the four cells around the hole keeps one of its two triangles.
  EXPECT_EQ(map->GetOutput()->GetNumberOfCells(), pipeline.Run()->GetNumberOfCells() - 4);
  EXPECT_EQ(CountBoundaryEdges(GetDirectedEdges(map->GetOutput())), 4);
}

TEST(LMS3DSurfaceReconstructionFilter, MapsTheRoom)
{
  Pipeline pipeline(ReadRoom());
  pipeline.Scan->SetPosition(0.3, -0.2, 1.0);
  vtkPolyData* map = pipeline.Run();
  ExpectFacing(map, { 0.3, -0.2, 1.0 });
  // Some cells at the silhouettes of the furniture stay open.
  EXPECT_GT(map->GetNumberOfCells(), 0.97 * 258480);
  EXPECT_LT(map->GetNumberOfCells(), 258480);
}

TEST(LMS3DSurfaceReconstructionFilter, TakesScansWithoutCells)
{
  Pipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetBetaResolution(1);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 0);
  EXPECT_EQ(pipeline.Map->GetErrorCode(), vtkErrorCode::NoError);
  pipeline.Scan->SetBetaResolution(360);
  pipeline.Scan->SetMaximumRange(1.0);
  EXPECT_EQ(UpdateAndGetError(pipeline.Map), "");
  EXPECT_EQ(pipeline.Map->GetOutput()->GetNumberOfPoints(), 0);
  pipeline.Scan->SetMaximumRange(80.0);
  pipeline.Scan->SetAlphaRange(0.0, 10.0);
  pipeline.Scan->SetAlphaResolution(2);
  pipeline.Scan->SetBetaRange(0.0, 10.0);
  pipeline.Scan->SetBetaResolution(2);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 2);
}

TEST(LMS3DSurfaceReconstructionFilter, RefusesWhatIsNoScan)
{
  Pipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(9);
  pipeline.Scan->SetBetaResolution(8);
  ExpectError(MakeBall(1.0), "Range");

  for (const char* name : { "Range", "BeamId" })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->RemoveArray(name);
    ExpectError(scan, name);
  }
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetFieldData()->RemoveArray(name);
    ExpectError(scan, name);
  }
}

TEST(LMS3DSurfaceReconstructionFilter, RefusesBadReturns)
{
  Pipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(9);
  pipeline.Scan->SetBetaResolution(8);
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 0.0, -1.0 })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->GetArray("Range")->SetTuple1(7, bad);
    ExpectError(scan, "Return 7 of the scan has the Range");
  }
  for (double bad :
    { std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity() })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPoints()->SetPoint(7, 1.0, bad, 2.0);
    ExpectError(scan, "Return 7 of the scan has the coordinate");
  }
  for (double bad : { -1.0, 72.0, 3.0 })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->GetArray("BeamId")->SetTuple1(7, bad);
    ExpectError(scan, "Return 7 of the scan has the BeamId");
  }
}
