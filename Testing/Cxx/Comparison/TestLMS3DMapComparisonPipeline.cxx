// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DMapComparison in a pipeline: inputs, outputs, getters, threads, abort, pieces.
 */
#include "Comparison/ComparisonFixtures.h"
#include "Fixtures/ProgressListener.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

TEST(LMS3DMapComparisonPipeline, HasTheSameBitsForAnyNumberOfThreads)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->Update();
  Comparison comparison(map->GetOutput(), ReadRoom(), scan->GetOutput());
  std::vector<std::vector<std::uint64_t>> runs;
  for (int threads : { 1, 2, 7 })
  {
    comparison.Filter->SetNumberOfThreads(threads);
    vtkPolyData* points = comparison.GetScenePoints();
    vtkPolyData* output = comparison.Filter->GetOutput();
    runs.push_back({ Hash(points), Hash(output->GetPointData()->GetArray("Error")),
      Hash(output->GetCellData()->GetArray("LargestError")) });
    for (const char* name : { "MapToScene", "SceneToMap", "NormalError", "Correctness",
           "Completeness", "AreaInFreeSpace", "LargestReturnDistance" })
    {
      runs.back().push_back(Hash(output->GetFieldData()->GetArray(name)));
    }
  }
  EXPECT_EQ(runs[0], runs[1]);
  EXPECT_EQ(runs[0], runs[2]);
}

TEST(LMS3DMapComparisonPipeline, TakesPoseAndReturnsFromTheScan)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(MakeBall(2.0));
  scan->SetAlphaResolution(19);
  scan->SetBetaResolution(36);
  scan->Update();
  const vtkIdType returns = scan->GetOutput()->GetNumberOfPoints();
  Comparison comparison(MakeBall(2.1), MakeBall(2.0), scan->GetOutput());
  comparison.Filter->SetTolerance(0.2);
  EXPECT_EQ(comparison.Update()->GetReturnsWithinTolerance(), 1.0);
  EXPECT_GT(comparison.Update()->GetLargestReturnDistance(), 0.099);
  EXPECT_LT(comparison.Update()->GetLargestReturnDistance(), 0.1 + 1e-7);

  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(scan->GetOutput());
  moved->GetPoints()->SetPoint(5, 0.0, 0.0, 0.0);
  Comparison withOutlier(MakeBall(2.1), MakeBall(2.0), moved);
  withOutlier.Filter->SetTolerance(0.2);
  EXPECT_DOUBLE_EQ(withOutlier.Update()->GetReturnsWithinTolerance(), 1.0 - 1.0 / returns);
  EXPECT_GT(withOutlier.Update()->GetLargestReturnDistance(), 2.0);
}

TEST(LMS3DMapComparisonPipeline, TakesThePoseFromTheMap)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(MakeBall(2.0));
  scan->SetPosition(0.5, 0.0, 0.0);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  // Every return is a vertex, so the map is complete.
  map->SetMaximumError(0.0);
  vtkNew<vtkLMS3DMapComparison> filter;
  filter->SetInputConnection(map->GetOutputPort());
  filter->SetSceneData(MakeBall(2.0));
  EXPECT_EQ(UpdateAndGetError(filter), "");
  vtkFieldData* results = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(results->GetArray("ReturnsWithinTolerance"), nullptr);
  EXPECT_EQ(results->GetArray("Completeness")->GetTuple1(0), 1.0);
  EXPECT_LT(results->GetArray("NormalError")->GetComponent(0, 0), 3.0);
}

TEST(LMS3DMapComparisonPipeline, LeavesItsInputsAlone)
{
  const auto map = MakeFloor(2.0, 0.03);
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->Update();
  EXPECT_EQ(map->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(map->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(map->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(comparison.Filter->GetOutput()->GetNumberOfCells(), 1);
}

TEST(LMS3DMapComparisonPipeline, SkipsCellsThatAreNotFinite)
{
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const auto map =
    Join(MakeFloor(2.0, 0.0), MakePolygon({ { bad, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  vtkNew<vtkTest::ErrorObserver> observer;
  comparison.Filter->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(comparison.Update()->GetMapToSceneMaximum(), 0.0);
  const std::string warning = observer->GetWarningMessage();
  EXPECT_NE(warning.find("The map: cells with a point that is not finite"), std::string::npos);
  EXPECT_NE(warning.find("left out: 1."), std::string::npos) << warning;
  vtkPolyData* output = comparison.Filter->GetOutput();
  EXPECT_TRUE(std::isnan(output->GetPointData()->GetArray("Error")->GetTuple1(4)));
  EXPECT_TRUE(std::isnan(output->GetCellData()->GetArray("LargestError")->GetTuple1(1)));
}

TEST(LMS3DMapComparisonPipeline, ReturnsTheSameResultsByGettersAndAsFieldData)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(MakeBall(2.0));
  SetGrid(scan, 19, 36);
  scan->Update();
  Comparison comparison(MakeBall(2.1), MakeBall(2.0), scan->GetOutput());
  EXPECT_TRUE(std::isnan(comparison.Filter->GetMapToSceneMean()));
  vtkLMS3DMapComparison* filter = comparison.Update();

  const std::pair<const char*, std::array<double, 4>> errors[] = {
    { "MapToScene",
      { filter->GetMapToSceneMean(), filter->GetMapToSceneRMS(),
        filter->GetMapToScenePercentile95(), filter->GetMapToSceneMaximum() } },
    { "SceneToMap",
      { filter->GetSceneToMapMean(), filter->GetSceneToMapRMS(),
        filter->GetSceneToMapPercentile95(), filter->GetSceneToMapMaximum() } },
    { "NormalError",
      { filter->GetNormalErrorMean(), filter->GetNormalErrorRMS(),
        filter->GetNormalErrorPercentile95(), filter->GetNormalErrorMaximum() } }
  };
  for (const auto& [name, expected] : errors)
  {
    comparison.ExpectErrors(name, expected, 0.0);
    EXPECT_TRUE(std::is_sorted(expected.begin(), expected.begin() + 2)) << name;
    EXPECT_LE(expected[2], expected[3]) << name;
  }
  const std::pair<const char*, double> numbers[] = { { "Correctness", filter->GetCorrectness() },
    { "Completeness", filter->GetCompleteness() }, { "FScore", filter->GetFScore() },
    { "AreaInFreeSpace", filter->GetAreaInFreeSpace() }, { "MapArea", filter->GetMapArea() },
    { "VisibleArea", filter->GetVisibleArea() },
    { "MapTriangles", static_cast<double>(filter->GetMapTriangles()) },
    { "ReturnsWithinTolerance", filter->GetReturnsWithinTolerance() },
    { "LargestReturnDistance", filter->GetLargestReturnDistance() } };
  for (const auto& [name, expected] : numbers)
  {
    EXPECT_EQ(comparison.GetField(name), expected) << name;
  }
}

TEST(LMS3DMapComparisonPipeline, ComparesAgainAfterAnAbort)
{
  const Point sensor = { 0.0, 0.0, 1.0 };
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), sensor);
  double aborted = 0.0;
  auto stopper = std::make_unique<ProgressListener>(comparison.Filter,
    [&](double progress)
    {
      if (progress >= aborted)
      {
        comparison.Filter->AbortExecuteOn();
      }
    });
  for (double share : { 0.3, 0.31, 0.45, 0.6, 0.7, 0.82, 0.9 })
  {
    aborted = share;
    comparison.Filter->Modified();
    comparison.Update();
    comparison.ExpectNoResults();
  }
  // The aborted outputs do not count as up to date: the filter runs again although nothing changed.
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  comparison.Filter->AddObserver(vtkCommand::StartEvent, counter);
  comparison.Update();
  EXPECT_EQ(runs, 1);
  stopper.reset();
  comparison.Filter->AbortExecuteOff();
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMean(), 0.03, 1e-12);
  EXPECT_EQ(comparison.Filter->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_GT(comparison.GetScenePoints()->GetNumberOfPoints(), 100000);
}

TEST(LMS3DMapComparisonPipeline, ReportsProgressInItsSearches)
{
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  std::vector<double> reports;
  const ProgressListener listener(
    comparison.Filter, [&](double progress) { reports.push_back(progress); });
  comparison.Update();
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  for (double first : { 0.3, 0.6 })
  {
    EXPECT_GT(std::count_if(reports.begin(), reports.end(),
                [first](double report) { return report > first && report < first + 0.29; }),
      1)
      << first;
  }
}

TEST(LMS3DMapComparisonPipeline, IsOnePiece)
{
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->UpdatePiece(1, 2, 0);
  comparison.ExpectNoResults();
  comparison.Filter->UpdatePiece(0, 2, 0);
  EXPECT_NEAR(comparison.Filter->GetMapToSceneMean(), 0.03, 1e-12);
}

TEST(LMS3DMapComparisonPipeline, ReportsAnErrorOnceForEachChange)
{
  vtkNew<vtkLMS3DMapComparison> comparison;
  comparison->SetInputData(0, MakeBall(2.0));
  comparison->SetInputData(1, MakeBall(2.0));
  EXPECT_EQ(UpdateAllAndCountErrors(comparison), 1);
  EXPECT_EQ(UpdateAllAndCountErrors(comparison), 0);
  comparison->SetTolerance(0.02);
  EXPECT_EQ(UpdateAllAndCountErrors(comparison), 1);
}
