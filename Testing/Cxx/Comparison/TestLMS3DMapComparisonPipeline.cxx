// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DMapComparison in a pipeline: inputs, outputs, getters, threads, abort, processes, errors.
 */
#include "Comparison/ComparisonFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDummyCommunicator.h>
#include <vtkDummyController.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

TEST(LMS3DMapComparisonPipeline, RefusesWhatCannotBeCompared)
{
  const auto surface = MakeFloor(2.0, 0.0);
  const Point sensor = { 0.0, 0.0, 1.0 };
  vtkNew<vtkPolyData> nothing;
  Comparison noMap(nothing, surface, sensor);
  noMap.ExpectError("The map has no triangles");
  Comparison noScene(surface, nothing, sensor);
  noScene.ExpectError("The scene has no triangles");
  Comparison noArea(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }), surface, sensor);
  noArea.ExpectError("The map has no triangles");
  Comparison points(MakePose(sensor), surface, sensor);
  points.ExpectError("The map has no triangles");
  Comparison noPose(surface, surface, nothing);
  noPose.ExpectError("SensorToWorld");
  Comparison farAway(surface, surface, Point{ 0.0, 0.0, 100.0 });
  farAway.ExpectError("sees nothing of the scene");

  vtkSmartPointer<vtkPolyData> pose = MakePose(sensor);
  AddDoubles(pose, "AlphaAngles", { -90.0, std::numeric_limits<double>::quiet_NaN() });
  Comparison badAngles(surface, surface, pose);
  badAngles.ExpectError("AlphaAngles is not finite");
  pose = MakePose(sensor);
  AddDoubles(pose, "SensorToWorld", { 1.0, 2.0 });
  Comparison badMatrix(surface, surface, pose);
  badMatrix.ExpectError("matrix of 16");
}

TEST(LMS3DMapComparisonPipeline, RefusesBadProperties)
{
  Comparison comparison(MakeFloor(2.0, 0.0), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->SetTolerance(std::numeric_limits<double>::quiet_NaN());
  comparison.ExpectError("Tolerance");
  comparison.Filter->SetTolerance(0.01);
  comparison.Filter->SetMinimumRange(5.0);
  comparison.Filter->SetMaximumRange(2.0);
  comparison.ExpectError("MinimumRange and MaximumRange are 5 and 2");
  comparison.Filter->SetMaximumRange(std::numeric_limits<double>::infinity());
  comparison.Filter->SetMinimumRange(0.0);
  EXPECT_EQ(UpdateAndGetError(comparison.Filter), "");
  EXPECT_EQ(comparison.Filter->GetErrorCode(), vtkErrorCode::NoError);
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
  vtkNew<vtkCallbackCommand> stopper;
  stopper->SetClientData(&aborted);
  stopper->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      vtkAlgorithm* algorithm = static_cast<vtkAlgorithm*>(caller);
      if (algorithm->GetProgress() >= *static_cast<double*>(data))
      {
        algorithm->AbortExecuteOn();
      }
    });
  const unsigned long tag = comparison.Filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  for (double share : { 0.3, 0.6, 0.9 })
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
  comparison.Filter->RemoveObserver(tag);
  comparison.Filter->AbortExecuteOff();
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMean(), 0.03, 1e-12);
  EXPECT_EQ(comparison.Filter->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_GT(comparison.GetScenePoints()->GetNumberOfPoints(), 100000);
}

TEST(LMS3DMapComparisonPipeline, IsOnePiece)
{
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->UpdatePiece(1, 2, 0);
  comparison.ExpectNoResults();
  comparison.Filter->UpdatePiece(0, 2, 0);
  EXPECT_NEAR(comparison.Filter->GetMapToSceneMean(), 0.03, 1e-12);
}

namespace
{
/// Two processes: this one, and one that has a part of the scene or nothing, and reports no error.
class TwoProcesses : public vtkDummyCommunicator
{
public:
  static TwoProcesses* New();
  vtkTypeMacro(TwoProcesses, vtkDummyCommunicator);

  int AllReduceVoidArray(
    const void* mine, void* all, vtkIdType length, int type, int operation) override
  {
    EXPECT_EQ(type, VTK_INT);
    std::copy_n(static_cast<const int*>(mine), length, static_cast<int*>(all));
    if (operation == SUM_OP && !this->HasCounted)
    {
      *static_cast<int*>(all) += this->OtherHasScene ? 1 : 0;
      this->HasCounted = true;
    }
    return 1;
  }
  int BroadcastVoidArray(void*, vtkIdType, int, int) override { return 1; }

  bool OtherHasScene = false;
  /// The first sum counts the parts of the scene, later ones the aborts.
  bool HasCounted = false;

protected:
  TwoProcesses()
  {
    this->MaximumNumberOfProcesses = 2;
    this->NumberOfProcesses = 2;
  }
};
vtkStandardNewMacro(TwoProcesses);
} // namespace

TEST(LMS3DMapComparisonPipeline, RefusesAPieceOfTheScene)
{
  vtkNew<TwoProcesses> processes;
  vtkNew<vtkDummyController> controller;
  controller->SetCommunicator(processes);
  ASSERT_EQ(controller->GetNumberOfProcesses(), 2);
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->SetController(controller);
  EXPECT_EQ(comparison.Filter->GetController(), controller);
  processes->OtherHasScene = true;
  comparison.ExpectError("The scene is spread over 2 processes");

  processes->OtherHasScene = false;
  processes->HasCounted = false;
  comparison.Filter->Modified();
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMean(), 0.03, 1e-12);

  // Without the controller this process compares alone.
  processes->OtherHasScene = true;
  processes->HasCounted = false;
  comparison.Filter->SetController(nullptr);
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMean(), 0.03, 1e-12);
  EXPECT_FALSE(processes->HasCounted);
}

TEST(LMS3DMapComparisonPipeline, ReportsTheErrorOfAProcessOfSeveral)
{
  vtkNew<TwoProcesses> processes;
  vtkNew<vtkDummyController> controller;
  controller->SetCommunicator(processes);
  const auto surface = MakeFloor(2.0, 0.0);
  Comparison comparison(surface, surface, Point{ 0.0, 0.0, 100.0 });
  comparison.Filter->SetController(controller);
  comparison.ExpectError("Process 0: The sensor at 0 0 100 sees nothing of the scene");
}

TEST(LMS3DMapComparisonPipeline, ComparesAloneWithAControllerOfOneProcess)
{
  vtkNew<vtkDummyController> controller;
  Comparison comparison(MakeFloor(2.0, 0.03), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.Filter->SetController(controller);
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMean(), 0.03, 1e-12);
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
