// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkLMS3DRangeErrorFilter refuses, and what it then reports.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
void ExpectRefused(vtkPolyData* scan, const std::string& words)
{
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputData(scan);
  filter->SetRangeNoise(0.01);
  const std::string error = UpdateAndGetError(filter);
  EXPECT_NE(error.find(words), std::string::npos) << error;
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
  ExpectEmpty(filter);
}

struct BadValue
{
  void (vtkLMS3DRangeErrorFilter::*Set)(double);
  double Value;
  const char* Words;
};
} // namespace

TEST(LMS3DRangeErrorErrors, RefusesBadProperties)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  using Filter = vtkLMS3DRangeErrorFilter;
  RangeErrorPipeline pipeline(MakeBall(2.0));
  SetGrid(pipeline.Scan, 9, 8);
  for (const BadValue& bad : { BadValue{ &Filter::SetRangeBias, nan, "RangeBias is nan m" },
         BadValue{ &Filter::SetRangeBias, -infinity, "RangeBias is -inf m" },
         BadValue{ &Filter::SetRangeNoise, -0.01, "RangeNoise is -0.01 m" },
         BadValue{ &Filter::SetRangeNoise, nan, "RangeNoise is nan m" },
         BadValue{ &Filter::SetRangeNoise, infinity, "RangeNoise is inf m" },
         BadValue{ &Filter::SetRangeResolution, -1.0, "RangeResolution is -1 m" },
         BadValue{ &Filter::SetRangeResolution, infinity, "RangeResolution is inf m" } })
  {
    (pipeline.Errors->*bad.Set)(bad.Value);
    const std::string error = UpdateAndGetError(pipeline.Errors);
    EXPECT_NE(error.find(bad.Words), std::string::npos) << error;
    EXPECT_EQ(pipeline.Errors->GetErrorCode(), vtkErrorCode::UserError);
    ExpectEmpty(pipeline.Errors);
    (pipeline.Errors->*bad.Set)(0.0);
    pipeline.Run();
    EXPECT_EQ(pipeline.Errors->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 72);
  }
}

TEST(LMS3DRangeErrorErrors, RefusesWhatIsNoScan)
{
  ExpectRefused(MakeBall(1.0), "The scan has no array Range");
  auto scan = MakeScan(MakeBall(2.0));
  SetGrid(scan, 9, 8);
  scan->Update();
  for (const char* name : { "Range", "BeamId" })
  {
    const auto copy = CopyData(scan->GetOutput());
    copy->GetPointData()->RemoveArray(name);
    ExpectRefused(copy, name);
  }
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    const auto copy = CopyData(scan->GetOutput());
    copy->GetFieldData()->RemoveArray(name);
    ExpectRefused(copy, name);
  }
}

TEST(LMS3DRangeErrorErrors, RefusesBadReturns)
{
  auto scan = MakeScan(MakeBall(2.0));
  SetGrid(scan, 9, 8);
  scan->Update();
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 0.0, -1.0 })
  {
    const auto copy = CopyData(scan->GetOutput());
    copy->GetPointData()->GetArray("Range")->SetTuple1(7, bad);
    ExpectRefused(copy, "Return 7 of the scan has the Range");
  }
  for (double bad : { -1.0, 72.0, 3.0 })
  {
    const auto copy = CopyData(scan->GetOutput());
    copy->GetPointData()->GetArray("BeamId")->SetTuple1(7, bad);
    ExpectRefused(copy, "Return 7 of the scan has the BeamId");
  }
}

TEST(LMS3DRangeErrorErrors, ReportsAnErrorOnceForEachChange)
{
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputData(MakeBall(2.0));
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 1);
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 0);
  filter->SetRangeNoise(0.02);
  EXPECT_EQ(UpdateAllAndCountErrors(filter), 1);
}

TEST(LMS3DRangeErrorErrors, AddsNoErrorToTheOneOfTheScan)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetBetaResolution(0);
  EXPECT_EQ(UpdateAllAndCountErrors(pipeline.Errors), 0);
  ExpectEmpty(pipeline.Errors);
}
