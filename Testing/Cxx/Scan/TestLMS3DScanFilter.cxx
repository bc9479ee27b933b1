// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

TEST(LMS3DScanFilter, DescribesEachReturn)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetAlphaRange(-60.0, 60.0);
  scan->SetBetaRange(10.0, 100.0);
  SetGrid(scan, 25, 19);
  scan->Update();

  vtkPolyData* output = scan->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 25 * 19);
  ASSERT_EQ(output->GetNumberOfVerts(), 25 * 19);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(GetArray(scan, "Range")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(GetArray(scan, "Alpha")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(GetArray(scan, "Beta")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(GetArray(scan, "BeamId")->GetDataType(), VTK_INT);
  EXPECT_EQ(GetArray(scan, "CellId")->GetDataType(), VTK_ID_TYPE);

  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double alpha = GetArray(scan, "Alpha")->GetTuple1(i);
    const double beta = GetArray(scan, "Beta")->GetTuple1(i);
    EXPECT_EQ(GetArray(scan, "BeamId")->GetTuple1(i), i);
    EXPECT_EQ(alpha, -60 + 5 * (i % 25));
    EXPECT_EQ(beta, 10 + 5 * (i / 25));
    const Point direction = GetPaperDirection(alpha, beta);
    Point p;
    output->GetPoint(i, p.data());
    EXPECT_NEAR(p[0], 0.3 + GetRange(scan, i) * direction[0], 1e-14);
    EXPECT_NEAR(p[1], -0.2 + GetRange(scan, i) * direction[1], 1e-14);
    EXPECT_NEAR(p[2], 1.0 + GetRange(scan, i) * direction[2], 1e-14);
  }

  vtkFieldData* fields = output->GetFieldData();
  EXPECT_EQ(fields->GetArray("AlphaAngles")->GetNumberOfTuples(), 25);
  EXPECT_EQ(fields->GetArray("AlphaAngles")->GetTuple1(24), 60.0);
  EXPECT_EQ(fields->GetArray("BetaAngles")->GetNumberOfTuples(), 19);
  EXPECT_EQ(fields->GetArray("BetaAngles")->GetTuple1(18), 100.0);
}

TEST(LMS3DScanFilter, LeavesTheEndOfAFullCircleOut)
{
  auto scan = MakeScan(MakeBall(1.0));
  SetGrid(scan, 1, 4);
  scan->SetAlphaRange(0.0, 0.0);
  scan->SetBetaRange(-90.0, 270.0);
  scan->Update();
  vtkDataArray* beta = scan->GetOutput()->GetFieldData()->GetArray("BetaAngles");
  ASSERT_EQ(beta->GetNumberOfTuples(), 4);
  EXPECT_EQ(beta->GetTuple1(0), -90.0);
  EXPECT_EQ(beta->GetTuple1(3), 180.0);
}

TEST(LMS3DScanFilter, TakesAFullCircleThatRoundingMakesLonger)
{
  const double start = 213.7;
  const double stop = 573.7;
  ASSERT_GT(stop - start, 360.0);
  auto scan = MakeScan(MakeBall(1.0));
  SetGrid(scan, 1, 4);
  scan->SetAlphaRange(0.0, 0.0);
  scan->SetBetaRange(start, stop);
  scan->Update();
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 4);
}

TEST(LMS3DScanFilter, MovesPointsRigidlyWithThePose)
{
  // A scene that is moved with the sensor looks the same to it.
  const double position[3] = { 3.0, -2.0, 0.5 };
  vtkNew<vtkTransform> pose;
  pose->Translate(position);
  pose->RotateZ(30.0);
  pose->RotateX(20.0);
  pose->RotateY(-10.0);
  vtkSmartPointer<vtkPolyData> ball = MakeBall(2.0, 12);
  vtkNew<vtkPoints> movedPoints;
  movedPoints->SetDataTypeToDouble();
  pose->TransformPoints(ball->GetPoints(), movedPoints);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(ball);
  moved->SetPoints(movedPoints);

  auto scan = MakeScan(ball);
  auto movedScan = MakeScan(moved);
  movedScan->SetPosition(position);
  movedScan->SetOrientation(20.0, -10.0, 30.0);
  for (vtkLMS3DScanFilter* each : { scan.Get(), movedScan.Get() })
  {
    SetGrid(each, 31, 36);
    each->Update();
    ASSERT_EQ(each->GetOutput()->GetNumberOfPoints(), 31 * 36);
  }
  for (vtkIdType i = 0; i < 31 * 36; ++i)
  {
    const double* expected = pose->TransformPoint(scan->GetOutput()->GetPoint(i));
    const double* actual = movedScan->GetOutput()->GetPoint(i);
    ASSERT_NEAR(vtkMath::Distance2BetweenPoints(expected, actual), 0.0, 1e-24);
  }
  vtkDataArray* matrix = movedScan->GetOutput()->GetFieldData()->GetArray("SensorToWorld");
  ASSERT_EQ(matrix->GetNumberOfTuples(), 16);
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(matrix->GetTuple1(i), pose->GetMatrix()->GetElement(i / 4, i % 4), 1e-15);
  }
}

TEST(LMS3DScanFilter, KeepsMissesInTheImageOnly)
{
  auto scan = MakeScan(MakeFloor(10.0, -1.0));
  SetGrid(scan, 19, 12);
  scan->Update();

  vtkImageData* image = scan->GetRangeImage();
  int dimensions[3];
  image->GetDimensions(dimensions);
  EXPECT_EQ(dimensions[0], 19);
  EXPECT_EQ(dimensions[1], 12);
  EXPECT_EQ(dimensions[2], 1);
  EXPECT_EQ(image->GetSpacing()[0], 10.0);
  EXPECT_EQ(image->GetSpacing()[1], 30.0);
  EXPECT_EQ(image->GetOrigin()[0], -90.0);

  vtkDataArray* ranges = image->GetPointData()->GetArray("Range");
  ASSERT_EQ(ranges->GetDataType(), VTK_DOUBLE);
  vtkIdType returns = 0;
  for (vtkIdType i = 0; i < 19 * 12; ++i)
  {
    const double range = ranges->GetTuple1(i);
    const bool looksDown = i % 19 < 9;
    EXPECT_EQ(std::isnan(range), !looksDown) << i;
    if (looksDown)
    {
      EXPECT_EQ(GetArray(scan, "BeamId")->GetTuple1(returns), i);
      EXPECT_EQ(GetRange(scan, returns), range);
      ++returns;
    }
  }
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), returns);
}

TEST(LMS3DScanFilter, GivesNoReturnOutsideOfTheRangeLimits)
{
  auto scan = MakeScan(Join(MakeBall(1.0), MakeBall(3.0)));
  SetGrid(scan, 9, 8);
  scan->SetMaximumRange(0.5);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  scan->SetMaximumRange(2.0);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 72);
  // The nearer ball hides the farther one, although it is too near to be measured.
  scan->SetMaximumRange(80.0);
  scan->SetMinimumRange(2.0);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DScanFilter, NeverReturnsTheSurfaceItStandsOn)
{
  auto scan = MakeScan(MakeFloor(10.0, 0.0));
  scan->SetPosition(0.25, 0.5, 0.0);
  SetGrid(scan, 19, 12);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DScanFilter, NumbersTheCellsOfTheScene)
{
  // A vertex, then a quadrilateral and a strip, so that a cell is not a triangle's number.
  vtkSmartPointer<vtkPolyData> surface = MakeFloor(1.0, -1.0);
  for (const Point& p :
    std::vector<Point>{ { -1, -1, 1 }, { 1, -1, 1 }, { -1, 1, 1 }, { 1, 1, 1 } })
  {
    surface->GetPoints()->InsertNextPoint(p.data());
  }
  const vtkIdType strip[4] = { 4, 5, 6, 7 };
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(4, strip);
  surface->SetStrips(strips);
  const vtkIdType vertex[1] = { 0 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, vertex);
  surface->SetVerts(vertices);

  auto scan = MakeScan(surface);
  SetGrid(scan, 2, 1);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 1.0);
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(1), 2.0);
}

TEST(LMS3DScanFilter, ScansConcavePolygons)
{
  // A U whose notch is free: straight up misses it, to its left and right it is hit.
  auto scan = MakeScan(MakePolygon({ { -3, -3, 1 }, { 3, -3, 1 }, { 3, 3, 1 }, { 1, 3, 1 },
    { 1, -1, 1 }, { -1, -1, 1 }, { -1, 3, 1 }, { -3, 3, 1 } }));
  scan->SetAlphaRange(60.0, 90.0);
  SetGrid(scan, 2, 1);
  scan->SetPosition(0.0, 1.0, 0.0);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  scan->SetPosition(2.0, 1.0, 0.0);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 2);
}
