// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Errors that are added to single turns: they equal the ones of the whole scan.
 */
#include "RangeErrors/RangeErrorFixtures.h"
#include "Scan/TrajectoryFixtures.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace
{
constexpr int Beams = 31;
constexpr int Turns = 8;

// Ranges as text, in which all NaN are alike.
std::vector<std::string> GetText(const std::vector<double>& ranges)
{
  std::vector<std::string> text;
  for (double range : ranges)
  {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%a", range);
    text.emplace_back(std::isnan(range) ? "nan" : digits);
  }
  return text;
}

std::vector<double> AddErrors(
  vtkLMS3DRangeErrorFilter* errors, double time, const std::vector<double>& grid)
{
  std::vector<double> reported;
  for (int turn = 0; turn < Turns; ++turn)
  {
    vtkNew<vtkDoubleArray> ranges;
    for (int beam = 0; beam < Beams; ++beam)
    {
      ranges->InsertNextValue(grid[turn * Beams + beam]);
    }
    EXPECT_TRUE(errors->AddErrors(time, turn, ranges));
    reported.insert(reported.end(), ranges->GetPointer(0), ranges->GetPointer(0) + Beams);
  }
  return reported;
}
} // namespace

TEST(LMS3DRangeErrorTurns, EqualTheWholeScan)
{
  RangeErrorPipeline pipeline(MakeOpenScene());
  SetGrid(pipeline.Scan, Beams, Turns);
  pipeline.Scan->SetTrajectoryData(MakePoses({ { 0, 0, 0 }, { 0.1, 0, 0 }, { 0.3, 0.1, 0 } }));
  AddAllErrors(pipeline.Errors);
  pipeline.Errors->SetNoiseSeed(5);
  for (double time : { 0.0, 2.0 })
  {
    pipeline.Errors->UpdateTimeStep(time);
    const std::vector<double> truth = GetRanges(pipeline.Scan->GetRangeImage());
    const std::vector<double> whole = GetRanges(pipeline.Errors->GetRangeImage());
    ASSERT_EQ(truth.size(), static_cast<std::size_t>(Beams) * Turns);
    EXPECT_NE(GetText(truth), GetText(whole));
    EXPECT_EQ(GetText(AddErrors(pipeline.Errors, time, truth)), GetText(whole));
  }
}

TEST(LMS3DRangeErrorTurns, LeaveRangesWithoutErrors)
{
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  vtkNew<vtkDoubleArray> ranges;
  ranges->InsertNextValue(0.12345);
  EXPECT_TRUE(errors->AddErrors(0.0, 3, ranges));
  EXPECT_EQ(ranges->GetValue(0), 0.12345);
}

TEST(LMS3DRangeErrorTurns, RefuseBadProperties)
{
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  errors->SetRangeBias(1.0);
  errors->SetRangeNoise(-0.01);
  vtkNew<vtkDoubleArray> ranges;
  ranges->InsertNextValue(2.0);
  vtkNew<vtkTest::ErrorObserver> observer;
  errors->AddObserver(vtkCommand::ErrorEvent, observer);
  EXPECT_FALSE(errors->AddErrors(0.0, 0, ranges));
  EXPECT_NE(observer->GetErrorMessage().find("RangeNoise is -0.01 m"), std::string::npos);
  EXPECT_EQ(ranges->GetValue(0), 2.0);
}

TEST(LMS3DRangeErrorTurns, RefuseBadArguments)
{
  vtkNew<vtkLMS3DRangeErrorFilter> errors;
  vtkNew<vtkDoubleArray> ranges;
  vtkNew<vtkTest::ErrorObserver> observer;
  errors->AddObserver(vtkCommand::ErrorEvent, observer);
  EXPECT_FALSE(errors->AddErrors(0.0, 0, nullptr));
  EXPECT_NE(observer->GetErrorMessage().find("no array of ranges"), std::string::npos);
  EXPECT_FALSE(errors->AddErrors(0.0, -1, ranges));
  EXPECT_NE(observer->GetErrorMessage().find("turn is below 0"), std::string::npos);
}
