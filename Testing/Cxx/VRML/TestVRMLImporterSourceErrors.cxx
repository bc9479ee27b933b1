// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The errors and warnings of vtkVRMLImporterSource, exceptions and abort.
 */
#include "Fixtures/ProgressListener.h"
#include "Fixtures/SceneFixtures.h"
#include "VRML/ImporterFixture.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

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
  this->Write(SquareScene + std::string("USE Missing\nShape { geometry Nurbs { } }\n"));
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
  std::string scene = SquareScene;
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
  this->Write(SquareScene + std::string("WorldInfo { author \"me\" }\n"));
  this->Reader->SetFileName(this->File.string().c_str());
  const std::string warning = UpdateAndGetWarning(this->Reader);
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
  // VTK holds a reference while it calls an observer, and loses the reference if the observer
  // throws.
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
  auto abort = std::make_unique<ProgressListener>(
    this->Reader, [&](double progress) { this->Reader->SetAbortExecute(progress > 0.3 ? 1 : 0); });
  EXPECT_EQ(UpdateAndGetError(this->Reader), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Reader->GetNumberOfMessages(), 0);

  abort.reset();
  this->Reader->SetAbortExecute(0);
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfCells(), 240000);
}
