// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scene's cell data on the returns of a scan.
 */
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"
#include "Scan/LabelledScan.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

namespace
{
void AddInts(vtkDataSet* data, const char* name, int first)
{
  vtkNew<vtkIntArray> values;
  values->SetName(name);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(first + static_cast<int>(cell));
  }
  data->GetCellData()->AddArray(values);
}

/// Compares an array of the scan with that of the scene at CellId.
void ExpectValuesOfCells(vtkLMS3DScanFilter* scan, vtkDataSet* scene, const char* name)
{
  vtkDataArray* expected = scene->GetCellData()->GetArray(name);
  vtkDataArray* found = GetArray(scan, name);
  ASSERT_NE(found, nullptr) << name;
  EXPECT_EQ(found->GetDataType(), expected->GetDataType());
  ASSERT_EQ(found->GetNumberOfComponents(), expected->GetNumberOfComponents());
  ASSERT_EQ(found->GetNumberOfTuples(), scan->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    const vtkIdType cell = static_cast<vtkIdType>(GetArray(scan, "CellId")->GetTuple1(i));
    for (int component = 0; component < found->GetNumberOfComponents(); ++component)
    {
      ASSERT_EQ(found->GetComponent(i, component), expected->GetComponent(cell, component)) << name;
    }
  }
}
} // namespace

TEST(LMS3DScanSurfaceAttributes, LabelsBelongToTheCellThatWasHit)
{
  auto room = ReadRoom();
  auto scan = MakeLabelledScan(room);
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->Update();
  ExpectValuesOfCells(scan, room, "ShapeId");
  ExpectValuesOfCells(scan, room, "Color");
  EXPECT_GT(GetArray(scan, "ShapeId")->GetRange()[1], GetArray(scan, "ShapeId")->GetRange()[0]);
  auto* names =
    vtkStringArray::SafeDownCast(scan->GetOutput()->GetFieldData()->GetAbstractArray("ShapeNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetNumberOfValues(),
    room->GetFieldData()->GetAbstractArray("ShapeNames")->GetNumberOfValues());
}

TEST(LMS3DScanSurfaceAttributes, NewLabelsAreSeenWithoutABuild)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Label", 0);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  const vtkMTimeType buildTime = scan->GetBuildTime();
  AddInts(ball, "Label", 100);
  scan->Update();
  ExpectValuesOfCells(scan, ball, "Label");
  EXPECT_GE(GetArray(scan, "Label")->GetRange()[0], 100.0);
  EXPECT_EQ(scan->GetBuildTime(), buildTime);
}

TEST(LMS3DScanSurfaceAttributes, CellsKeepTheirNumbersBesideVerticesLinesAndStrips)
{
  auto scene = Join(MakeFloor(10.0, -1.0), MakeBall(5.0, 12));
  const vtkIdType corners[4] = { 0, 1, 3, 2 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, corners);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, corners);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(4, corners);
  scene->SetVerts(vertices);
  scene->SetLines(lines);
  scene->SetStrips(strips);
  AddInts(scene, "Label", 7);
  auto scan = MakeLabelledScan(scene);
  scan->Update();
  ExpectValuesOfCells(scan, scene, "Label");
  EXPECT_EQ(GetArray(scan, "Label")->GetRange()[0], 9.0);
}

TEST(LMS3DScanSurfaceAttributes, AVolumeGivesTheDataOfItsCells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 5);
  image->SetOrigin(-2.0, -2.0, -2.0);
  AddInts(image, "Label", 0);
  auto scan = MakeLabelledScan(image);
  scan->SetPosition(0.3, 0.2, 4.0);
  scan->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 100);
  ExpectValuesOfCells(scan, image, "Label");
}

TEST(LMS3DScanSurfaceAttributes, StringsArePassed)
{
  auto scene = Join(MakeFloor(10.0, -1.0), MakeFloor(10.0, 1.0));
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("floor");
  names->InsertNextValue("ceiling");
  scene->GetCellData()->AddArray(names);
  auto scan = MakeLabelledScan(scene);
  scan->Update();
  auto* found =
    vtkStringArray::SafeDownCast(scan->GetOutput()->GetPointData()->GetAbstractArray("Name"));
  ASSERT_NE(found, nullptr);
  ASSERT_GT(found->GetNumberOfValues(), 0);
  for (vtkIdType i = 0; i < found->GetNumberOfValues(); ++i)
  {
    const bool isFloor = GetArray(scan, "CellId")->GetTuple1(i) == 0.0;
    ASSERT_EQ(found->GetValue(i), isFloor ? "floor" : "ceiling");
  }
}

TEST(LMS3DScanSurfaceAttributes, ArraysThatMeanSomethingElseOnAScanAreLeftOut)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Range", 0);
  AddInts(ball, "Normals", 0);
  AddInts(ball, "Label", 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(ball->GetNumberOfCells());
  ghosts->FillValue(vtkDataSetAttributes::DUPLICATECELL);
  ball->GetCellData()->AddArray(ghosts);
  // Too short.
  vtkNew<vtkIntArray> shortArray;
  shortArray->SetName("Short");
  shortArray->InsertNextValue(1);
  ball->GetCellData()->AddArray(shortArray);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  vtkPointData* arrays = scan->GetOutput()->GetPointData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 8);
  EXPECT_EQ(arrays->GetArray("Range")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(arrays->GetArray("Normals")->GetDataType(), VTK_FLOAT);
  EXPECT_TRUE(arrays->HasArray("Label"));
}

TEST(LMS3DScanSurfaceAttributes, GlobalIdsNameTheCells)
{
  auto ball = MakeBall(1.0, 12);
  AddInts(ball, "Label", 0);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  const int last = static_cast<int>(ball->GetNumberOfCells()) - 1;
  for (int cell = 0; cell <= last; ++cell)
  {
    ids->InsertNextValue(last - cell);
  }
  ball->GetCellData()->SetGlobalIds(ids);
  auto scan = MakeLabelledScan(ball);
  scan->Update();
  ASSERT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(GetArray(scan, "Label")->GetTuple1(i), last - GetArray(scan, "CellId")->GetTuple1(i));
  }
  EXPECT_EQ(GetArray(scan, "Ids"), nullptr);
}

TEST(LMS3DScanSurfaceAttributes, BlocksGiveTheArraysThatAllHave)
{
  auto floor = MakeFloor(10.0, -1.0);
  auto ball = MakeBall(5.0, 12);
  AddInts(floor, "Label", 0);
  AddInts(ball, "Label", 1);
  AddInts(ball, "BallOnly", 0);
  AddInts(floor, "OtherType", 0);
  vtkNew<vtkIdTypeArray> otherType;
  otherType->SetName("OtherType");
  otherType->SetNumberOfValues(ball->GetNumberOfCells());
  ball->GetCellData()->AddArray(otherType);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, floor);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  blocks->SetBlock(3, ball);
  auto scan = MakeLabelledScan(blocks);
  scan->Update();
  vtkDataArray* labels = GetArray(scan, "Label");
  ASSERT_NE(labels, nullptr);
  // Cells are numbered through.
  EXPECT_EQ(Hash(labels),
    [scan]
    {
      vtkNew<vtkIntArray> cells;
      cells->DeepCopy(GetArray(scan, "CellId"));
      return Hash(cells);
    }());
  EXPECT_EQ(labels->GetRange()[0], 0.0);
  EXPECT_GT(labels->GetRange()[1], 0.0);
  EXPECT_EQ(GetArray(scan, "BallOnly"), nullptr);
  EXPECT_EQ(GetArray(scan, "OtherType"), nullptr);
}
