// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The array Status of a scan that passes vtkLMS3DRangeErrorFilter.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace
{
vtkDataArray* GetStatus(vtkPolyData* scan)
{
  return scan->GetFieldData()->GetArray("Status");
}

vtkDataArray* GetStatus(vtkImageData* image)
{
  return image->GetPointData()->GetArray("Status");
}
} // namespace

TEST(LMS3DRangeErrorStatus, PassesOnWithAndWithoutErrors)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->ComputeStatusOn();
  for (bool hasErrors : { false, true })
  {
    if (hasErrors)
    {
      AddAllErrors(pipeline.Errors);
    }
    pipeline.Run();
    vtkDataArray* ideal = GetStatus(pipeline.Scan->GetOutput());
    vtkDataArray* ofScan = GetStatus(pipeline.Errors->GetOutput());
    vtkDataArray* ofImage = GetStatus(pipeline.Errors->GetRangeImage());
    ASSERT_TRUE(ideal && ofScan && ofImage);
    // One copy in memory.
    EXPECT_EQ(ofScan->GetVoidPointer(0), ideal->GetVoidPointer(0));
    EXPECT_EQ(ofImage->GetVoidPointer(0), ideal->GetVoidPointer(0));
    EXPECT_STREQ(
      pipeline.Errors->GetRangeImage()->GetPointData()->GetScalars()->GetName(), "Range");
  }
}

TEST(LMS3DRangeErrorStatus, OfRemovedReturnsIsTooNear)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Scan->ComputeStatusOn();
  pipeline.Errors->SetRangeBias(-2.0);
  pipeline.Run();
  vtkDataArray* ideal = GetStatus(pipeline.Scan->GetOutput());
  vtkDataArray* ofScan = GetStatus(pipeline.Errors->GetOutput());
  vtkDataArray* ofImage = GetStatus(pipeline.Errors->GetRangeImage());
  ASSERT_TRUE(ideal && ofScan && ofImage);
  const std::vector<double> ranges = GetRanges(pipeline.Errors->GetRangeImage());
  ASSERT_EQ(ofImage->GetNumberOfTuples(), static_cast<vtkIdType>(ranges.size()));
  int removed = 0;
  for (vtkIdType beam = 0; beam < ofImage->GetNumberOfTuples(); ++beam)
  {
    const bool isRemoved =
      ideal->GetTuple1(beam) == vtkLMS3DScanFilter::RETURN && std::isnan(ranges[beam]);
    removed += isRemoved ? 1 : 0;
    const double tooNear = vtkLMS3DScanFilter::TOO_NEAR;
    const double expected = isRemoved ? tooNear : ideal->GetTuple1(beam);
    ASSERT_EQ(ofImage->GetTuple1(beam), expected) << beam;
    ASSERT_EQ(ofScan->GetTuple1(beam), expected) << beam;
  }
  EXPECT_EQ(removed,
    pipeline.Scan->GetOutput()->GetNumberOfPoints() -
      pipeline.Errors->GetOutput()->GetNumberOfPoints());
  EXPECT_GT(removed, 0);
  // The ideal scan keeps its own.
  const std::uint64_t before = Hash(ideal);
  pipeline.Scan->Modified();
  pipeline.Scan->Update();
  EXPECT_EQ(Hash(GetStatus(pipeline.Scan->GetOutput())), before);
}

TEST(LMS3DRangeErrorStatus, IsNotInventedAndABadOneIsIgnored)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  AddAllErrors(pipeline.Errors);
  pipeline.Run();
  EXPECT_EQ(GetStatus(pipeline.Errors->GetOutput()), nullptr);
  EXPECT_EQ(GetStatus(pipeline.Errors->GetRangeImage()), nullptr);
  auto scan = CopyData(pipeline.Scan->GetOutput());
  vtkNew<vtkUnsignedCharArray> tooShort;
  tooShort->SetName("Status");
  tooShort->InsertNextValue(1);
  scan->GetFieldData()->AddArray(tooShort);
  pipeline.Errors->SetInputData(scan);
  pipeline.Run();
  EXPECT_EQ(GetStatus(pipeline.Errors->GetRangeImage()), nullptr);
  EXPECT_EQ(GetStatus(pipeline.Errors->GetOutput())->GetNumberOfTuples(), 1);
}
