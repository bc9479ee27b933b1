// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"
#include "VRML/ImporterFixture.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <sstream>

TEST_F(VRMLImporterSource, ReadsTheRoomOfThePaper)
{
  vtkSmartPointer<vtkPolyData> room = ReadRoom();
  EXPECT_EQ(room->GetNumberOfCells(), 804);
  EXPECT_EQ(room->GetNumberOfPolys(), 804);
  double bounds[6];
  room->GetBounds(bounds);
  EXPECT_EQ(bounds[0], -4.0);
  EXPECT_EQ(bounds[4], 0.0);
  EXPECT_EQ(bounds[5], 3.0);

  vtkDataArray* shapes = room->GetCellData()->GetArray("ShapeId");
  ASSERT_EQ(shapes->GetDataType(), VTK_INT);
  EXPECT_EQ(shapes->GetRange()[0], 0.0);
  vtkAbstractArray* names = room->GetFieldData()->GetAbstractArray("ShapeNames");
  ASSERT_NE(vtkStringArray::SafeDownCast(names), nullptr);
  EXPECT_EQ(names->GetNumberOfValues(), static_cast<vtkIdType>(shapes->GetRange()[1]) + 1);
}

TEST_F(VRMLImporterSource, ReadsPlacesAndColours)
{
  this->Write(SquareScene);
  this->Reader->SetFileName(this->File.string().c_str());
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  vtkPolyData* square = this->Reader->GetOutput();
  ASSERT_EQ(square->GetNumberOfCells(), 2);
  double bounds[6];
  square->GetBounds(bounds);
  const double expected[6] = { 1, 2, 2, 2, 3, 5 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(bounds[i], expected[i]);
  }
  vtkDataArray* color = square->GetCellData()->GetArray("Color");
  ASSERT_EQ(color->GetDataType(), VTK_UNSIGNED_CHAR);
  ASSERT_EQ(color->GetNumberOfComponents(), 4);
  const double rgba[4] = { 255, 153, 51, 153 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(color->GetComponent(0, i), rgba[i]);
  }
  EXPECT_EQ(this->Reader->GetNumberOfMessages(), 0);
}

TEST_F(VRMLImporterSource, TurnsYUpToZUp)
{
  this->Write(SquareScene);
  this->Reader->SetFileName(this->File.string().c_str());
  this->Reader->SetUpAxisToY();
  this->Reader->Update();
  double bounds[6];
  this->Reader->GetOutput()->GetBounds(bounds);
  const double expected[6] = { 1, 2, -5, -3, 2, 2 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(bounds[i], expected[i]);
  }
}

TEST_F(VRMLImporterSource, ReadsTheFileAgainEachTime)
{
  this->Write(SquareScene);
  this->Reader->SetFileName(this->File.string().c_str());
  for (int i = 0; i < 3; ++i)
  {
    this->Reader->Modified();
    this->Reader->Update();
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 2);
  }
  this->Reader->SetFileName(LMS3D_DATA_DIR "/room.wrl");
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 804);
}

TEST_F(VRMLImporterSource, ContinuesThePipelineAfterAnError)
{
  this->Reader->SetFileName((this->File.string() + ".not").c_str());
  for (int processes : { 1, 2 })
  {
    this->Reader->Modified();
    EXPECT_EQ(this->Reader->UpdatePiece(0, processes, 0), 1);
    EXPECT_EQ(
      this->Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST_F(VRMLImporterSource, NamesShapesByTheNearestDEF)
{
  this->Write(SquareScene +
    std::string("DEF Room Group { children [ DEF Box Shape { geometry Box { } }"
                " Shape { geometry Box { } } ] } Shape { geometry Box { } }"));
  this->Reader->SetFileName(this->File.string().c_str());
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  auto* names = vtkStringArray::SafeDownCast(
    this->Reader->GetOutput()->GetFieldData()->GetAbstractArray("ShapeNames"));
  ASSERT_EQ(names->GetNumberOfValues(), 4);
  const char* const expected[] = { "Wall", "Box", "Room", "" };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(names->GetValue(i), expected[i]);
  }
}

TEST_F(VRMLImporterSource, ReadsWithVTKsImporterToo)
{
  this->Write(SquareScene);
  this->Reader->SetFileName(this->File.string().c_str());
  this->Reader->SetEngineToVTKImporter();
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(this->Reader->GetNumberOfMessages(), 0);

  const std::string crossed = R"(Shape { geometry IndexedFaceSet {
  coord Coordinate { point [ 0 0 0, 1 1 0, 1 0 0, 0 1 0 ] }
  coordIndex [ 0, 1, 2, -1, 0, 1, 2, 3, -1 ]
} }
)";
  this->Write(SquareScene + crossed + crossed);
  this->Reader->Modified();
  const std::string error = UpdateAndGetError(this->Reader);
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 4);
  ASSERT_EQ(this->Reader->GetNumberOfMessages(), 2);
  EXPECT_EQ(this->Reader->GetMessage(0), "shape 1: 2 of 3 triangles could not be made");
  EXPECT_EQ(this->Reader->GetMessage(1), "shape 2: 2 of 3 triangles could not be made");
  EXPECT_NE(error.find(this->Reader->GetMessage(0)), std::string::npos) << error;
}

TEST_F(VRMLImporterSource, HasTwoEngines)
{
  EXPECT_EQ(this->Reader->GetEngine(), vtkVRMLImporterSource::VRML97);
  this->Reader->SetEngine(7);
  EXPECT_EQ(this->Reader->GetEngine(), vtkVRMLImporterSource::VTK_IMPORTER);
  this->Reader->SetEngineToVRML97();
  EXPECT_EQ(this->Reader->GetEngine(), 0);
  std::ostringstream words;
  this->Reader->Print(words);
  EXPECT_NE(words.str().find("Engine: VRML97"), std::string::npos) << words.str();
}

TEST_F(VRMLImporterSource, RecognisesItsFiles)
{
  EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(LMS3D_DATA_DIR "/room.wrl"), 1);
  EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(LMS3D_DATA_DIR "/make_room.py"), 0);
  EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(LMS3D_DATA_DIR "/none.wrl"), 0);
  EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(LMS3D_DATA_DIR), 0);
  EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(nullptr), 0);
}
