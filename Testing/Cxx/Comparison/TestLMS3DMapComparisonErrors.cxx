// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Inputs and properties that vtkLMS3DMapComparison refuses, in one process and in several.
 */
#include "Comparison/ComparisonFixtures.h"

#include <vtkCellArray.h>
#include <vtkDummyCommunicator.h>
#include <vtkDummyController.h>
#include <vtkErrorCode.h>
#include <vtkObjectFactory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

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
  pose = MakePose(sensor);
  AddDoubles(pose, "SensorToWorld", std::vector<double>(16, 0.0));
  Comparison noAxes(surface, surface, pose);
  noAxes.ExpectError("scales an axis by 0");
}

TEST(LMS3DMapComparisonPipeline, NamesTheInputWithABadCell)
{
  const auto surface = MakeFloor(2.0, 0.0);
  const Point sensor = { 0.0, 0.0, 1.0 };
  const auto bad = MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  bad->GetPolys()->InsertNextCell({ 0, 1, 7 });
  Comparison badMap(bad, surface, sensor);
  badMap.ExpectError("The map: cell 1 uses point 7 of 3");
  Comparison badScene(surface, bad, sensor);
  badScene.ExpectError("The scene: cell 1 uses point 7 of 3");
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
