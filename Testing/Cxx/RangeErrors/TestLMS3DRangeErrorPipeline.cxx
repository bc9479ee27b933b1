// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DRangeErrorFilter in a pipeline: threads, times, pieces, progress, abort.
 */
#include "Fixtures/ProgressListener.h"
#include "RangeErrors/RangeErrorFixtures.h"
#include "Scan/TrajectoryFixtures.h"

#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

TEST(LMS3DRangeErrorPipeline, HasTheSameBitsForAnyNumberOfThreads)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  pipeline.Errors->SetRangeNoise(0.005);
  pipeline.Errors->SetRangeResolution(0.001);
  pipeline.Errors->SetNumberOfThreads(1);
  pipeline.Run();
  const std::uint64_t scan = Hash(pipeline.Errors->GetOutput());
  const std::uint64_t image = Hash(pipeline.Errors->GetRangeImage());
  for (int threads : { 2, 3, 8, 0 })
  {
    pipeline.Errors->SetNumberOfThreads(threads);
    pipeline.Run();
    EXPECT_EQ(Hash(pipeline.Errors->GetOutput()), scan) << threads;
    EXPECT_EQ(Hash(pipeline.Errors->GetRangeImage()), image) << threads;
  }
}

TEST(LMS3DRangeErrorPipeline, HasErrorsOfItsOwnForEachTimeOfATrajectory)
{
  // The pose stays, so only the time differs.
  const auto poses = MakePoses({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } });
  vtkSmartPointer<vtkLMS3DScanFilter> scan = MakeScanAlong(poses);
  SetGrid(scan, 91, 90);
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputConnection(scan->GetOutputPort());
  filter->SetRangeNoise(0.01);
  std::vector<std::vector<double>> errors;
  for (double time : { 0.0, 1.0, 2.0, 1.0 })
  {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
    EXPECT_EQ(
      filter->GetRangeImage()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
    errors.push_back(GetRanges(filter->GetOutput()));
    const std::vector<double> truth = GetRanges(scan->GetOutput());
    ASSERT_EQ(errors.back().size(), truth.size());
    std::transform(errors.back().begin(), errors.back().end(), truth.begin(), errors.back().begin(),
      [](double reported, double range) { return reported - range; });
  }
  const double bound = 4.0 / std::sqrt(static_cast<double>(errors[0].size()));
  EXPECT_LT(std::abs(GetCorrelation(errors[0], errors[1])), bound);
  EXPECT_LT(std::abs(GetCorrelation(errors[1], errors[2])), bound);
  EXPECT_EQ(errors[1], errors[3]);
}

TEST(LMS3DRangeErrorPipeline, PassesTheTimesOfATrajectory)
{
  vtkSmartPointer<vtkLMS3DScanFilter> scan = MakeScanAlong(MakePoses(ThreePositions));
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputConnection(scan->GetOutputPort());
  filter->UpdateInformation();
  for (int port : { 0, 1 })
  {
    EXPECT_EQ(
      filter->GetOutputInformation(port)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()),
      3);
  }
}

TEST(LMS3DRangeErrorPipeline, IsOnePiece)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  SetGrid(pipeline.Scan, 9, 8);
  pipeline.Errors->UpdatePiece(1, 2, 0);
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 0);
  pipeline.Errors->UpdatePiece(0, 2, 0);
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 72);
  EXPECT_EQ(pipeline.Errors->GetRangeImage()->GetNumberOfPoints(), 72);
}

TEST(LMS3DRangeErrorPipeline, FollowsTheGridOfTheScan)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  vtkLMS3DRangeErrorFilter* filter = pipeline.Errors;
  filter->SetRangeNoise(0.005);
  for (int turns : { 8, 16, 4 })
  {
    SetGrid(pipeline.Scan, 9, turns);
    pipeline.Run();
    EXPECT_EQ(filter->GetRangeImage()->GetNumberOfPoints(), 9 * turns);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9 * turns);
    filter->Update(1);
    EXPECT_EQ(filter->GetRangeImage()->GetDimensions()[1], turns);
  }
}

TEST(LMS3DRangeErrorPipeline, ScansOnceForAnUpdate)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  SetGrid(pipeline.Scan, 9, 8);
  // With more threads, the number of reports of a scan differs from run to run.
  pipeline.Scan->SetNumberOfThreads(1);
  int scans = 0;
  const ProgressListener listener(
    pipeline.Scan, [&scans](double share) { scans += share == 1.0 ? 1 : 0; });
  pipeline.Scan->Update();
  const int first = scans;
  pipeline.Scan->SetPosition(0.1, 0.0, 0.0);
  pipeline.Run();
  EXPECT_EQ(scans, 2 * first);
  // A request for information does not scan.
  pipeline.Scan->SetPosition(0.2, 0.0, 0.0);
  pipeline.Errors->UpdateInformation();
  EXPECT_EQ(scans, 2 * first);
  pipeline.Scan->SetPosition(0.1, 0.0, 0.0);
  pipeline.Run();
  EXPECT_EQ(scans, 3 * first);
  pipeline.Errors->SetRangeNoise(0.01);
  pipeline.Run();
  pipeline.Errors->Update(1);
  EXPECT_EQ(scans, 3 * first);
}

TEST(LMS3DRangeErrorPipeline, TakesAScanThatPublishesNoExtent)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  SetGrid(pipeline.Scan, 19, 36);
  pipeline.Errors->SetRangeNoise(0.01);
  pipeline.Run();
  vtkNew<vtkLMS3DRangeErrorFilter> filter;
  filter->SetInputData(CopyData(pipeline.Scan->GetOutput()));
  filter->SetRangeNoise(0.01);
  filter->UpdateInformation();
  const int* extent =
    filter->GetOutputInformation(1)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  EXPECT_EQ(extent[1], 18);
  EXPECT_EQ(extent[3], 35);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  EXPECT_EQ(Hash(filter->GetOutput()), Hash(pipeline.Errors->GetOutput()));
  EXPECT_EQ(Hash(filter->GetRangeImage()), Hash(pipeline.Errors->GetRangeImage()));
}

TEST(LMS3DRangeErrorPipeline, StopsAndIsWholeAgainAfterwards)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  vtkLMS3DRangeErrorFilter* filter = pipeline.Errors;
  filter->SetRangeNoise(0.005);
  pipeline.Run();
  for (double stop : { 0.1, 0.5 })
  {
    const ProgressListener stopper(filter,
      [&](double share)
      {
        if (share > stop)
        {
          filter->AbortExecuteOn();
        }
      });
    filter->Modified();
    filter->Update();
    ExpectEmpty(filter);
  }
  filter->AbortExecuteOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 361 * 360);
  EXPECT_EQ(filter->GetRangeImage()->GetNumberOfPoints(), 361 * 360);
}

TEST(LMS3DRangeErrorPipeline, TakesAScanWithoutReturns)
{
  RangeErrorPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetMaximumRange(1.0);
  pipeline.Errors->SetRangeNoise(0.005);
  pipeline.Run();
  EXPECT_EQ(pipeline.Errors->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(Hash(pipeline.Errors->GetRangeImage()), Hash(pipeline.Scan->GetRangeImage()));
}
