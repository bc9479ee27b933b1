// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which changes make vtkLMS3DScanFilter build its acceleration structure.
 */
#include "Fixtures/SceneFixtures.h"

#include "Scan/lms3dBuiltScene.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkAppendFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <functional>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  array->FillValue(1.0);
  return array;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid()
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(MakeBall(1.0, 12));
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 3);
  image->SetOrigin(-1.0, -1.0, -1.0);
  return image;
}

/// Scans a scene, changes it, and scans again.
class Builds
{
public:
  explicit Builds(vtkDataObject* scene)
    : Scan(MakeScan(scene))
  {
    SetGrid(this->Scan, 9, 8);
    this->Scan->Update();
  }

  /// Returns whether an update after the change builds.
  bool After(const std::function<void()>& change)
  {
    const vtkMTimeType last = this->Scan->GetBuildTime();
    change();
    this->Scan->Modified();
    EXPECT_EQ(UpdateAndGetError(this->Scan), "");
    return this->Scan->GetBuildTime() != last;
  }

  const vtkSmartPointer<vtkLMS3DScanFilter> Scan;
};

void AddArrays(vtkDataSet* data)
{
  data->GetPointData()->AddArray(MakeArray("New", data->GetNumberOfPoints()));
  data->GetCellData()->AddArray(MakeArray("New", data->GetNumberOfCells()));
}

} // namespace

TEST(LMS3DScanBuild, NewArraysDoNotBuild)
{
  auto ball = MakeBall(1.0, 12);
  Builds polygons(ball);
  EXPECT_FALSE(polygons.After([&] { AddArrays(ball); }));
  EXPECT_FALSE(polygons.After(
    [&]
    {
      ball->GetPointData()->GetArray("New")->SetTuple1(0, 7.0);
      ball->GetPointData()->GetArray("New")->Modified();
    }));
  EXPECT_FALSE(polygons.After([&] { ball->GetPointData()->RemoveArray("New"); }));

  auto grid = MakeGrid();
  EXPECT_FALSE(Builds(grid).After([&] { AddArrays(grid); }));

  auto image = MakeImage();
  EXPECT_FALSE(Builds(image).After([&] { AddArrays(image); }));
}

TEST(LMS3DScanBuild, NewArraysDoNotBuildWhereATriangleHasNoArea)
{
  auto ball = MakeBall(1.0, 12);
  const vtkIdType line[] = { 0, 1, 1 };
  ball->GetPolys()->InsertNextCell(3, line);
  ball->Modified();
  Builds builds(ball);
  builds.Scan->SetIntersectionMethodToFast();
  builds.Scan->Update();
  EXPECT_FALSE(builds.After([&] { AddArrays(ball); }));
}

TEST(LMS3DScanBuild, NewArraysOfABlockDoNotBuild)
{
  auto ball = MakeBall(1.0, 12);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, ball);
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  outer->SetBlock(1, MakeBall(2.0, 12));
  EXPECT_FALSE(Builds(outer).After([&] { AddArrays(ball); }));
}

TEST(LMS3DScanBuild, AnotherDataSetOfTheSameGeometryDoesNotBuild)
{
  // As a filter does that adds an array.
  auto ball = MakeBall(1.0, 12);
  Builds builds(ball);
  vtkNew<vtkPolyData> colored;
  colored->ShallowCopy(ball);
  AddArrays(colored);
  EXPECT_FALSE(builds.After([&] { builds.Scan->SetInputDataObject(colored); }));
  EXPECT_TRUE(builds.After([&] { builds.Scan->SetInputDataObject(MakeBall(1.1, 12)); }));
}

TEST(LMS3DScanBuild, MovedPointsBuild)
{
  auto ball = MakeBall(1.0, 12);
  Builds builds(ball);
  EXPECT_TRUE(builds.After(
    [&]
    {
      ball->GetPoints()->SetPoint(0, 0.0, 0.0, 1.1);
      ball->GetPoints()->Modified();
    }));
  EXPECT_TRUE(builds.After(
    [&]
    {
      ball->GetPoints()->GetData()->SetComponent(0, 2, 1.2);
      ball->GetPoints()->GetData()->Modified();
    }));
  // Scripts that change the array in place often mark nothing but the data set.
  EXPECT_TRUE(builds.After(
    [&]
    {
      ball->GetPoints()->SetPoint(0, 0.0, 0.0, 1.3);
      ball->Modified();
    }));
}

TEST(LMS3DScanBuild, ChangedCellsBuild)
{
  auto ball = MakeBall(1.0, 12);
  Builds builds(ball);
  const vtkIdType corners[3] = { 0, 1, 10 };
  EXPECT_TRUE(builds.After(
    [&]
    {
      ball->GetPolys()->InsertNextCell(3, corners);
      ball->Modified();
    }));
  EXPECT_TRUE(builds.After(
    [&]
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      ghosts->SetNumberOfValues(ball->GetNumberOfCells());
      ghosts->FillValue(0);
      ghosts->SetValue(3, vtkDataSetAttributes::HIDDENCELL);
      ball->GetCellData()->AddArray(ghosts);
    }));
  EXPECT_TRUE(builds.After(
    [&]
    {
      vtkNew<vtkIdTypeArray> ids;
      ids->SetName("Ids");
      for (vtkIdType cell = ball->GetNumberOfCells(); cell > 0; --cell)
      {
        ids->InsertNextValue(cell - 1);
      }
      ball->GetCellData()->SetGlobalIds(ids);
    }));
}

TEST(LMS3DScanBuild, AMovedImageBuilds)
{
  auto image = MakeImage();
  Builds builds(image);
  EXPECT_TRUE(builds.After([&] { image->SetOrigin(-1.0, -1.0, -1.5); }));
  EXPECT_TRUE(builds.After([&] { image->SetSpacing(1.0, 1.0, 1.1); }));
  EXPECT_TRUE(builds.After([&] { image->SetDimensions(3, 3, 4); }));
}

// As in a process that has no part of the scene.
TEST(LMS3DScanBuild, ASceneWithoutTrianglesIsUpToDateAfterOneUpdate)
{
  vtkNew<vtkPolyData> nothing;
  int calls = 0;
  const auto count = [&calls](double) { return ++calls > 0; };
  lms3dBuiltScene scene;
  ASSERT_TRUE(scene.Update(nothing, vtkLMS3DScanFilter::EXACT, count));
  EXPECT_EQ(scene.GetCaster(), nullptr);
  const vtkMTimeType built = scene.GetBuildTime();
  EXPECT_GT(built, 0u);

  calls = 0;
  EXPECT_TRUE(scene.Update(nothing, vtkLMS3DScanFilter::EXACT, count));
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(scene.GetBuildTime(), built);

  EXPECT_TRUE(scene.Update(MakeBall(1.0, 12), vtkLMS3DScanFilter::EXACT, count));
  EXPECT_NE(scene.GetCaster(), nullptr);
  EXPECT_GT(scene.GetBuildTime(), built);
}

TEST(LMS3DScanBuild, AnotherMethodBuilds)
{
  Builds builds(MakeBall(1.0, 12));
  EXPECT_TRUE(builds.After([&] { builds.Scan->SetIntersectionMethodToFast(); }));
  EXPECT_TRUE(builds.After([&] { builds.Scan->SetIntersectionMethodToExact(); }));
}

TEST(LMS3DScanBuild, ASceneThatLostItsPolygonsIsNotScannedAgain)
{
  auto ball = MakeBall(1.0, 12);
  auto scan = MakeScan(ball);
  scan->Update();
  vtkNew<vtkCellArray> none;
  ball->SetPolys(none);
  scan->Modified();
  EXPECT_NE(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}
