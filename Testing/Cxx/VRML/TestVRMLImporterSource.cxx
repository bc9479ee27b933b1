// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkVRMLImporterSource.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{
const char* const Square = R"(#VRML V2.0 utf8
DEF Wall Transform {
  translation 1 2 3
  children Shape {
    appearance Appearance { material Material { diffuseColor 1 0.6 0.2 transparency 0.4 } }
    geometry IndexedFaceSet {
      coord Coordinate { point [ 0 0 0, 1 0 0, 1 0 2, 0 0 2 ] }
      coordIndex [ 0, 1, 2, 3, -1 ]
    }
  }
}
)";

class VRMLImporterSource : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->File = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".wrl");
  }

  void TearDown() override { std::filesystem::remove_all(this->File); }

  void Write(const std::string& words) { std::ofstream(this->File, std::ios::binary) << words; }

  void ExpectError(unsigned long code, const std::string& word)
  {
    const std::string error = UpdateAndGetError(this->Reader);
    EXPECT_NE(error.find(word), std::string::npos) << error;
    EXPECT_EQ(this->Reader->GetErrorCode(), code);
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  }

  std::filesystem::path File;
  vtkNew<vtkVRMLImporterSource> Reader;
};
} // namespace

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
  this->Write(Square);
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
  this->Write(Square);
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
  this->Write(Square);
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

TEST_F(VRMLImporterSource, RejectsFilesThatAreNotScenes)
{
  this->ExpectError(vtkErrorCode::NoFileNameError, "no FileName");
  this->Reader->SetFileName(this->File.string().c_str());
  this->ExpectError(vtkErrorCode::FileNotFoundError, "does not exist");
  this->Reader->SetFileName(this->File.parent_path().string().c_str());
  this->ExpectError(vtkErrorCode::FileNotFoundError, "regular file");

  this->Reader->SetFileName(this->File.string().c_str());
  for (const auto& [words, word] : std::vector<std::pair<const char*, const char*>>{
         { "", "#VRML V2.0" }, { "#VRML V1.0 ascii\nCube {}\n", "VRML 1.0" },
         { "#Inventor V2.1 ascii\n", "Open Inventor" }, { "solid x", "#VRML V2.0" } })
  {
    this->Write(words);
    this->Reader->Modified();
    EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(this->File.string().c_str()), 1);
    this->ExpectError(vtkErrorCode::UnrecognizedFileTypeError, word);
    const std::filesystem::path other = this->File.string() + ".txt";
    std::filesystem::copy_file(
      this->File, other, std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(vtkVRMLImporterSource::CanReadFile(other.string().c_str()), 0);
    std::filesystem::remove(other);
  }
  this->Write("#VRML V2.0 utf8\nWorldInfo { title \"nothing\" }\n");
  this->Reader->Modified();
  this->ExpectError(vtkErrorCode::FileFormatError, "no surface");
}

TEST_F(VRMLImporterSource, ReportsAnErrorOnceForEachChange)
{
  this->Write("#VRML V1.0 ascii\nCube {}\n");
  this->Reader->SetFileName(this->File.string().c_str());
  EXPECT_EQ(UpdateAllAndCountErrors(this->Reader), 1);
  EXPECT_EQ(UpdateAllAndCountErrors(this->Reader), 0);
  this->Reader->Modified();
  EXPECT_EQ(UpdateAllAndCountErrors(this->Reader), 1);
}

TEST_F(VRMLImporterSource, ReportsLossesOncePerExecution)
{
  this->Write(Square + std::string("USE Missing\nShape { geometry Nurbs { } }\n"));
  this->Reader->SetFileName(this->File.string().c_str());
  for (int i = 0; i < 2; ++i)
  {
    this->Reader->Modified();
    const std::string error = UpdateAndGetError(this->Reader);
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 2);
    EXPECT_EQ(this->Reader->GetErrorCode(), vtkErrorCode::NoError);
    ASSERT_EQ(this->Reader->GetNumberOfMessages(), 2);
    const std::string file = this->File.string();
    EXPECT_EQ(
      this->Reader->GetMessage(0), file + ":12: USE Missing: no earlier node has this name");
    EXPECT_EQ(this->Reader->GetMessage(1), file + ":13: VRML97 has no node Nurbs; it is skipped");
    EXPECT_EQ(this->Reader->GetMessageSeverity(0), vtkVRMLImporterSource::MESSAGE_ERROR);
    const std::string list = std::string("All 2 messages:\n") + this->Reader->GetMessage(0) + "\n" +
      this->Reader->GetMessage(1);
    EXPECT_NE(error.find(list), std::string::npos) << error;
  }
  EXPECT_EQ(this->Reader->GetMessage(2), "");
  EXPECT_EQ(this->Reader->GetMessageSeverity(-1), vtkVRMLImporterSource::MESSAGE_WARNING);
}

TEST_F(VRMLImporterSource, ListsTwentyMessagesAtMost)
{
  std::string scene = Square;
  for (int i = 0; i < 22; ++i)
  {
    scene.append("USE Missing").append(std::to_string(i)).append("\n");
  }
  this->Write(scene);
  this->Reader->SetFileName(this->File.string().c_str());
  const std::string error = UpdateAndGetError(this->Reader);
  EXPECT_EQ(this->Reader->GetNumberOfMessages(), 22);
  EXPECT_NE(error.find("Missing19: no earlier node"), std::string::npos) << error;
  EXPECT_EQ(error.find("Missing20: no earlier node"), std::string::npos) << error;
  EXPECT_NE(error.find("and so on, see GetMessage"), std::string::npos) << error;
}

TEST_F(VRMLImporterSource, WarnsIfNothingIsLost)
{
  this->Write(Square + std::string("WorldInfo { author \"me\" }\n"));
  this->Reader->SetFileName(this->File.string().c_str());
  std::string warning;
  vtkNew<vtkCallbackCommand> keeper;
  keeper->SetClientData(&warning);
  keeper->SetCallback([](vtkObject*, unsigned long, void* clientData, void* callData)
    { *static_cast<std::string*>(clientData) += static_cast<const char*>(callData); });
  this->Reader->AddObserver(vtkCommand::WarningEvent, keeper);
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  ASSERT_EQ(this->Reader->GetNumberOfMessages(), 1);
  EXPECT_EQ(this->Reader->GetMessageSeverity(0), vtkVRMLImporterSource::MESSAGE_WARNING);
  EXPECT_NE(warning.find(this->Reader->GetMessage(0)), std::string::npos) << warning;
}

TEST_F(VRMLImporterSource, ReportsTheErrorRatherThanAnEarlierWarning)
{
  this->Write("#VRML V2.0 utf8\nGroup { foo 1 }\nInline { url \"gone.wrl\" }\n");
  this->Reader->SetFileName(this->File.string().c_str());
  this->ExpectError(vtkErrorCode::FileFormatError, "gone.wrl");
}

TEST_F(VRMLImporterSource, ReportsAnyExceptionAsAnError)
{
  std::string text = "#VRML V2.0 utf8\n";
  for (int i = 0; i < 5000; ++i)
  {
    text += "Shape { geometry Box { } }\n";
  }
  this->Write(text);
  this->Reader->SetFileName(this->File.string().c_str());
  vtkNew<vtkCallbackCommand> thrower;
  thrower->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      // VTK itself reports 0 and 1, outside the reader.
      const double progress = static_cast<vtkVRMLImporterSource*>(caller)->GetProgress();
      if (progress > 0.0 && progress < 1.0)
      {
        throw std::runtime_error("thrown by an observer");
      }
    });
  const unsigned long tag = this->Reader->AddObserver(vtkCommand::ProgressEvent, thrower);
  EXPECT_NO_THROW(this->ExpectError(vtkErrorCode::UserError, "thrown by an observer"));
  this->Reader->RemoveObserver(tag);
  // VTK holds a reference while it calls an observer, and loses the reference if the observer throws.
  while (thrower->GetReferenceCount() > 1)
  {
    thrower->UnRegister(nullptr);
  }
  this->Reader->Modified();
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 60000);
}

TEST_F(VRMLImporterSource, IsEmptyWithoutAnErrorAfterAnAbort)
{
  std::string text = "#VRML V2.0 utf8\nGroup { foo 1 }\n";
  for (int i = 0; i < 20000; ++i)
  {
    text += "Shape { geometry Box { } }\n";
  }
  this->Write(text);
  this->Reader->SetFileName(this->File.string().c_str());
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* reader = static_cast<vtkVRMLImporterSource*>(caller);
      reader->SetAbortExecute(reader->GetProgress() > 0.3 ? 1 : 0);
    });
  const unsigned long tag = this->Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Reader->GetNumberOfMessages(), 0);

  this->Reader->RemoveObserver(tag);
  this->Reader->SetAbortExecute(0);
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 240000);
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
  this->Write(Square +
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
  this->Write(Square);
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
  this->Write(Square + crossed + crossed);
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
