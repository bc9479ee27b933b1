// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cell arrays that vtkLMS3DScanFilter takes as ReflectanceArray, and the errors of
 * others.
 */
#include "Scan/DetectionFixtures.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace
{
void SetColor(vtkPolyData* scene, const std::vector<unsigned char>& color)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Reflectance");
  colors->SetNumberOfComponents(static_cast<int>(color.size()));
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    colors->InsertNextTypedTuple(color.data());
  }
  scene->GetCellData()->AddArray(colors);
}

/// The intensity of one beam at right angles, which is the reflectance.
float GetReflectance(vtkDataObject* scene)
{
  auto scan = MakeBeam(scene);
  scan->SetReflectanceArray("Reflectance");
  scan->ComputeIntensityOn();
  EXPECT_TRUE(HasReturn(scan));
  return static_cast<float>(GetArray(scan, "Intensity")->GetTuple1(0));
}

template <typename ArrayT>
float GetReflectanceOf(typename ArrayT::ValueType value)
{
  auto wall = MakeWall(2.0);
  vtkNew<ArrayT> array;
  array->SetName("Reflectance");
  array->InsertNextValue(value);
  wall->GetCellData()->AddArray(array);
  return GetReflectance(wall);
}

std::string GetError(vtkDataObject* scene, const char* name = "Reflectance")
{
  auto scan = MakeBeam(scene);
  scan->SetReflectanceArray(name);
  scan->SetRangeAtTenPercent(10.0);
  const std::string error = UpdateAndGetError(scan);
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  return error;
}

void ExpectPart(const std::string& error, const std::string& part)
{
  EXPECT_NE(error.find(part), std::string::npos) << error;
}
} // namespace

TEST(LMS3DScanReflectanceArrays, OneComponentIsTheReflectance)
{
  EXPECT_EQ(GetReflectanceOf<vtkFloatArray>(0.3f), 0.3f);
  EXPECT_EQ(GetReflectanceOf<vtkIntArray>(2), 2.0f);
  EXPECT_EQ(GetReflectanceOf<vtkUnsignedCharArray>(1), 1.0f);
  EXPECT_EQ(GetReflectance(Paint(MakeWall(2.0), 20.5)), 20.5f);
}

TEST(LMS3DScanReflectanceArrays, AColourIsItsLuminance)
{
  const std::pair<std::vector<unsigned char>, double> Colors[] = {
    { { 255, 255, 255 }, 1.0 },
    { { 0, 0, 0 }, 0.0 },
    { { 255, 0, 0 }, 0.2126 },
    { { 0, 255, 0 }, 0.7152 },
    { { 0, 0, 255 }, 0.0722 },
    { { 51, 51, 51 }, 0.2 },
    // Opacity does not count.
    { { 255, 255, 255, 0 }, 1.0 },
    { { 0, 51, 0, 255 }, 0.2 * 0.7152 },
  };
  for (const auto& [color, luminance] : Colors)
  {
    auto wall = MakeWall(2.0);
    SetColor(wall, color);
    EXPECT_EQ(GetReflectance(wall), static_cast<float>(luminance));
  }
}

TEST(LMS3DScanReflectanceArrays, NewValuesNeedNoBuild)
{
  auto wall = Paint(MakeWall(2.0), 0.5);
  auto scan = MakeBeam(wall);
  SeeTenPercentAtTenMetres(scan);
  EXPECT_TRUE(HasReturn(scan));
  const vtkMTimeType buildTime = scan->GetBuildTime();
  Paint(wall, 0.0);
  EXPECT_FALSE(HasReturn(scan));
  SetReflectances(wall, { 0.7 }, "Other");
  scan->SetReflectanceArray("Other");
  EXPECT_TRUE(HasReturn(scan));
  scan->SetReflectanceArray("Reflectance");
  EXPECT_FALSE(HasReturn(scan));
  EXPECT_EQ(scan->GetBuildTime(), buildTime);
  // Values changed in place.
  wall->GetCellData()->GetArray("Reflectance")->SetTuple1(0, 1.0);
  wall->GetCellData()->GetArray("Reflectance")->Modified();
  EXPECT_TRUE(HasReturn(scan));
}

TEST(LMS3DScanReflectanceArrays, CellsKeepTheirNumbersBesideVerticesAndLines)
{
  auto scene = Join(MakeWall(2.0), MakeFloor(10.0, -5.0));
  const vtkIdType corners[2] = { 0, 1 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, corners);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, corners);
  scene->SetVerts(vertices);
  scene->SetLines(lines);
  // Cells without a surface may have any value.
  SetReflectances(scene, { -1.0, std::numeric_limits<double>::quiet_NaN(), 0.25, 0.75 });
  EXPECT_EQ(GetReflectance(scene), 0.25f);
}

TEST(LMS3DScanReflectanceArrays, HiddenCellsMayHaveAnyValue)
{
  auto scene = Join(MakeWall(1.0), MakeWall(2.0));
  SetReflectances(scene, { -1.0, 0.5 });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(vtkDataSetAttributes::HIDDENCELL);
  ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATECELL);
  scene->GetCellData()->AddArray(ghosts);
  EXPECT_EQ(GetReflectance(scene), 0.5f);
}

TEST(LMS3DScanReflectanceArrays, ReflectanceBelongsToTheCellThatGlobalIdsName)
{
  auto scene = Join(MakeWall(2.0), MakeWall(3.0));
  SetReflectances(scene, { 0.25, 0.75 });
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  ids->InsertNextValue(1);
  ids->InsertNextValue(0);
  scene->GetCellData()->SetGlobalIds(ids);
  EXPECT_EQ(GetReflectance(scene), 0.25f);
}

TEST(LMS3DScanReflectanceArrays, AVolumeHasTheReflectanceOfItsCells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 2);
  image->SetOrigin(2.0, -0.5, -0.5);
  SetReflectances(image, { 0.25, 0.75 });
  EXPECT_EQ(GetReflectance(image), 0.25f);
}

TEST(LMS3DScanReflectanceArrays, EachDataSetOfACompositeHasItsOwn)
{
  auto wall = MakeWall(2.0);
  SetColor(wall, { 0, 255, 0 });
  auto floor = Paint(MakeFloor(10.0, -1.0), 0.5);
  // A data set without a surface needs no array.
  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(MakeFloor(1.0, 1.0));
  lines->SetLines(lines->GetPolys());
  lines->SetPolys(nullptr);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, lines);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, floor);
  blocks->SetBlock(3, vtkNew<vtkPolyData>());
  blocks->SetBlock(4, wall);
  EXPECT_EQ(GetReflectance(blocks), 0.7152f);
  wall->GetCellData()->RemoveArray("Reflectance");
  ExpectPart(GetError(blocks),
    "ReflectanceArray is \"Reflectance\", but data set 3 of the scene has no such cell array. It "
    "has no "
    "cell arrays.");
}

TEST(LMS3DScanReflectanceArrays, AMissingArrayIsAnErrorThatListsTheOthers)
{
  ExpectPart(GetError(ReadRoom()),
    "ReflectanceArray is \"Reflectance\", but the scene has no such cell array. Its cell arrays "
    "are: "
    "ShapeId, Color.");
  auto scan = MakeBeam(ReadRoom());
  scan->SetReflectanceArray("Reflectance");
  scan->ComputeIntensityOn();
  ExpectPart(UpdateAndGetError(scan), "ReflectanceArray");
  scan->SetReflectanceArray("Color");
  EXPECT_TRUE(HasReturn(scan));
}

TEST(LMS3DScanReflectanceArrays, ABadTypeIsAnError)
{
  auto wall = MakeWall(2.0);
  const auto expect = [&wall](vtkAbstractArray* array, const std::string& words)
  {
    array->SetName("Reflectance");
    wall->GetCellData()->AddArray(array);
    ExpectPart(GetError(wall),
      "ReflectanceArray is \"Reflectance\", but in the scene it has components of the type " +
        words +
        " for each cell. One component of any number type (the reflectance), or three or four of "
        "unsigned char (a colour), are expected.");
  };
  vtkNew<vtkStringArray> names;
  names->InsertNextValue("grey");
  expect(names, "string, 1");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->InsertNextTuple3(1.0, 1.0, 1.0);
  expect(vectors, "float, 3");
  vtkNew<vtkUnsignedCharArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->InsertNextTuple2(1.0, 1.0);
  expect(pairs, "unsigned char, 2");
}

TEST(LMS3DScanReflectanceArrays, TooFewValuesAreAnError)
{
  auto scene = Join(MakeWall(1.0), MakeWall(2.0));
  SetReflectances(scene, { 0.5 });
  ExpectPart(GetError(scene), "but in the scene it has only 1 values for 2 cells.");
}

TEST(LMS3DScanReflectanceArrays, ABadValueIsAnErrorThatNamesTheCell)
{
  auto scene = Join(MakeWall(1.0), MakeWall(2.0));
  SetReflectances(scene, { 0.5, -0.1 });
  ExpectPart(GetError(scene),
    "The reflectance of cell 1 in \"Reflectance\" is -0.1; a finite number of 0 or more is "
    "expected.");
  for (double value :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    SetReflectances(scene, { value, 1.0 });
    ExpectPart(GetError(scene), "The reflectance of cell 0 in \"Reflectance\" is ");
  }
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  ids->InsertNextValue(17);
  ids->InsertNextValue(3);
  scene->GetCellData()->SetGlobalIds(ids);
  ExpectPart(GetError(scene), "The reflectance of cell 17 in");
}
