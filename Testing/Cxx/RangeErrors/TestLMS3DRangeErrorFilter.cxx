// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The outputs of vtkLMS3DRangeErrorFilter: which bits change, and which do not.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>

TEST(LMS3DRangeErrorFilter, ChangesNoBitByDefault)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->SetOrientation(10.0, 20.0, 30.0);
  pipeline.Run();
  vtkPolyData* scan = pipeline.Scan->GetOutput();
  vtkPolyData* reported = pipeline.Errors->GetOutput();
  ASSERT_GT(scan->GetNumberOfPoints(), 10000);
  ASSERT_LT(scan->GetNumberOfPoints(), 361 * 360);
  EXPECT_EQ(Hash(reported), Hash(scan));
  EXPECT_EQ(Hash(pipeline.Errors->GetRangeImage()), Hash(pipeline.Scan->GetRangeImage()));
  EXPECT_EQ(reported->GetPoints()->GetData(), scan->GetPoints()->GetData());
  EXPECT_EQ(reported->GetPointData()->GetArray("Range"), scan->GetPointData()->GetArray("Range"));
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    EXPECT_EQ(reported->GetFieldData()->GetArray(name), scan->GetFieldData()->GetArray(name));
  }
}

TEST(LMS3DRangeErrorFilter, HasTheGridOfTheScanAsImage)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->SetAlphaRange(-70.0, 33.0);
  pipeline.Scan->SetBetaRange(15.0, 99.0);
  SetGrid(pipeline.Scan, 37, 23);
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  vtkImageData* image = pipeline.Errors->GetRangeImage();
  vtkImageData* ideal = pipeline.Scan->GetRangeImage();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(image->GetDimensions()[axis], ideal->GetDimensions()[axis]);
    EXPECT_EQ(image->GetOrigin()[axis], ideal->GetOrigin()[axis]);
    EXPECT_EQ(image->GetSpacing()[axis], ideal->GetSpacing()[axis]);
  }
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Range");
}

TEST(LMS3DRangeErrorFilter, KeepsPointsRangesAndImageConsistent)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->SetPosition(0.1, -0.2, 0.3);
  pipeline.Scan->SetOrientation(10.0, 20.0, 30.0);
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  vtkPolyData* scan = pipeline.Scan->GetOutput();
  vtkPolyData* reported = pipeline.Errors->GetOutput();
  ASSERT_EQ(reported->GetNumberOfPoints(), scan->GetNumberOfPoints());
  ExpectImageOfScan(pipeline.Errors->GetRangeImage(), reported);
  const std::vector<double> truth = GetRanges(scan);
  const std::vector<double> ranges = GetRanges(reported);
  const Point sensor = { 0.1, -0.2, 0.3 };
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const double* before = scan->GetPoint(static_cast<vtkIdType>(i));
    const Point hit = { before[0], before[1], before[2] };
    const double* after = reported->GetPoint(static_cast<vtkIdType>(i));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double expected = sensor[axis] + ranges[i] / truth[i] * (hit[axis] - sensor[axis]);
      ASSERT_NEAR(after[axis], expected, 1e-14) << i;
    }
  }
}

TEST(LMS3DRangeErrorFilter, PlacesPointsAsTheScanDoes)
{
  // A bias from one ball to another gives the points that a scan of the other would have.
  RangeErrorPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetPosition(0.5, 0.25, -0.125);
  pipeline.Run();
  const auto moved = CopyData(pipeline.Scan->GetOutput());
  vtkDataArray* ranges = moved->GetPointData()->GetArray("Range");
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    ranges->SetTuple1(i, ranges->GetTuple1(i) - 0.25);
  }
  vtkNew<vtkLMS3DRangeErrorFilter> back;
  back->SetInputData(moved);
  back->SetRangeBias(0.25);
  EXPECT_EQ(UpdateAndGetError(back), "");
  const std::vector<double> found = GetRanges(back->GetOutput());
  const std::vector<double> expected = GetRanges(pipeline.Scan->GetOutput());
  int same = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i] == expected[i])
    {
      const vtkIdType number = static_cast<vtkIdType>(i);
      const double* point = back->GetOutput()->GetPoint(number);
      const Point copy = { point[0], point[1], point[2] };
      const double* original = pipeline.Scan->GetOutput()->GetPoint(number);
      ASSERT_EQ(copy, (Point{ original[0], original[1], original[2] })) << i;
      ++same;
    }
  }
  EXPECT_GT(same, 100000);
}

TEST(LMS3DRangeErrorFilter, PassesAllOtherArrays)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->SurfaceAttributesOn();
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  vtkPolyData* scan = pipeline.Scan->GetOutput();
  vtkPolyData* reported = pipeline.Errors->GetOutput();
  ASSERT_EQ(
    reported->GetPointData()->GetNumberOfArrays(), scan->GetPointData()->GetNumberOfArrays());
  for (const char* name : { "Alpha", "Beta", "BeamId", "CellId", "Normals", "Incidence" })
  {
    EXPECT_EQ(reported->GetPointData()->GetArray(name), scan->GetPointData()->GetArray(name));
  }
  EXPECT_STREQ(reported->GetPointData()->GetScalars()->GetName(), "Range");
  EXPECT_STREQ(reported->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_EQ(reported->GetNumberOfVerts(), scan->GetNumberOfVerts());
}

TEST(LMS3DRangeErrorFilter, LeavesItsInputAlone)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->Update();
  const std::uint64_t before = Hash(pipeline.Scan->GetOutput());
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  EXPECT_EQ(Hash(pipeline.Scan->GetOutput()), before);
}

TEST(LMS3DRangeErrorFilter, KeepsSinglePrecision)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  SetGrid(pipeline.Scan, 19, 36);
  pipeline.Scan->Update();
  const auto scan = CopyData(pipeline.Scan->GetOutput());
  vtkNew<vtkFloatArray> ranges;
  ranges->DeepCopy(scan->GetPointData()->GetArray("Range"));
  scan->GetPointData()->AddArray(ranges);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(scan->GetPoints());
  scan->SetPoints(points);
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputData(scan);
  filter->SetRangeBias(0.5);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  vtkDataArray* reported = filter->GetOutput()->GetPointData()->GetArray("Range");
  EXPECT_EQ(reported->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(filter->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(reported->GetTuple1(3), static_cast<float>(ranges->GetTuple1(3) + 0.5));
}

TEST(LMS3DRangeErrorFilter, GivesAScanThatTheReconstructionTakes)
{
  RangeErrorPipeline pipeline(ReadRoom());
  pipeline.Scan->SetPosition(0.3, -0.2, 1.0);
  pipeline.Errors->SetRangeNoise(0.005);
  pipeline.Errors->SetRangeResolution(0.001);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(pipeline.Errors->GetOutputPort());
  for (double bound : { 0.03, 0.0 })
  {
    map->SetMaximumError(bound);
    EXPECT_EQ(UpdateAndGetError(map), "");
    EXPECT_GT(map->GetOutput()->GetNumberOfPolys(), 1000);
  }
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 361 * 360);
}
