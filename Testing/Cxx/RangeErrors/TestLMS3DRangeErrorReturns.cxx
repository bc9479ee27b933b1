// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which beams vtkLMS3DRangeErrorFilter gives a return, and in which order.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
// The returns of a scan with these numbers, in this order.
vtkSmartPointer<vtkPolyData> Reorder(vtkPolyData* scan, const std::vector<vtkIdType>& order)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkPointData* arrays = result->GetPointData();
  arrays->CopyAllocate(scan->GetPointData());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    points->InsertNextPoint(scan->GetPoint(order[i]));
    arrays->CopyData(scan->GetPointData(), order[i], static_cast<vtkIdType>(i));
  }
  result->SetPoints(points);
  result->GetFieldData()->ShallowCopy(scan->GetFieldData());
  return result;
}
} // namespace

TEST(LMS3DRangeErrorReturns, LeavesBeamsWithoutAReturnAlone)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  const std::vector<double> ideal = GetRanges(pipeline.Scan->GetRangeImage());
  const std::vector<double> reported = GetRanges(pipeline.Errors->GetRangeImage());
  ASSERT_EQ(reported.size(), ideal.size());
  for (std::size_t beam = 0; beam < ideal.size(); ++beam)
  {
    ASSERT_EQ(std::isnan(reported[beam]), std::isnan(ideal[beam])) << beam;
  }
}

TEST(LMS3DRangeErrorReturns, RemovesReturnsThatWouldNotBeAboveZero)
{
  // The floor is from 1.5 m on, the ceiling from 2.5 m on.
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->SurfaceAttributesOn();
  pipeline.Errors->SetRangeBias(-2.0);
  pipeline.Run();
  vtkPolyData* scan = pipeline.Scan->GetOutput();
  vtkPolyData* reported = pipeline.Errors->GetOutput();
  vtkIdType expected = 0;
  for (double range : GetRanges(scan))
  {
    expected += range > 2.0 ? 1 : 0;
  }
  ASSERT_LT(expected, scan->GetNumberOfPoints());
  ASSERT_EQ(reported->GetNumberOfPoints(), expected);
  EXPECT_EQ(reported->GetNumberOfVerts(), expected);
  EXPECT_EQ(
    reported->GetPointData()->GetNumberOfArrays(), scan->GetPointData()->GetNumberOfArrays());
  EXPECT_STREQ(reported->GetPointData()->GetScalars()->GetName(), "Range");
  EXPECT_STREQ(reported->GetPointData()->GetNormals()->GetName(), "Normals");
  for (double range : GetRanges(reported))
  {
    ASSERT_GT(range, 0.0);
  }
  ExpectImageOfScan(pipeline.Errors->GetRangeImage(), reported);
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    EXPECT_NE(reported->GetFieldData()->GetArray(name), nullptr) << name;
  }

  // A reading of 0 is no measurement.
  pipeline.Errors->SetRangeBias(0.0);
  pipeline.Errors->SetRangeResolution(4.0);
  pipeline.Run();
  EXPECT_LT(pipeline.Errors->GetOutput()->GetNumberOfPoints(), scan->GetNumberOfPoints());
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetPointData()->GetArray("Range")->GetRange()[0], 4.0);
  pipeline.Errors->SetRangeBias(-1e6);
  pipeline.Run();
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DRangeErrorReturns, DoesNotDependOnOtherReturnsOrTheirOrder)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  const std::vector<double> expected = GetRanges(pipeline.Errors->GetRangeImage());
  const vtkIdType count = pipeline.Scan->GetOutput()->GetNumberOfPoints();
  std::vector<vtkIdType> order;
  for (vtkIdType i = count - 1; i >= 0; i -= 3)
  {
    order.push_back(i);
  }
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputData(Reorder(pipeline.Scan->GetOutput(), order));
  AddAllErrors(filter);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  vtkPolyData* reported = filter->GetOutput();
  ASSERT_EQ(reported->GetNumberOfPoints(), static_cast<vtkIdType>(order.size()));
  vtkDataArray* ids = reported->GetPointData()->GetArray("BeamId");
  const std::vector<double> ranges = GetRanges(reported);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const vtkIdType number = static_cast<vtkIdType>(i);
    ASSERT_EQ(ranges[i], expected[static_cast<std::size_t>(ids->GetTuple1(number))]) << i;
    const double* point = reported->GetPoint(number);
    const Point copy = { point[0], point[1], point[2] };
    const double* other = pipeline.Errors->GetOutput()->GetPoint(order[i]);
    ASSERT_EQ(copy, (Point{ other[0], other[1], other[2] })) << i;
  }
  ExpectImageOfScan(filter->GetRangeImage(), reported);
}
