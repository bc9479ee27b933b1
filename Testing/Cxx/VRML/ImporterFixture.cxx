// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VRML/ImporterFixture.h"

#include "Fixtures/SceneFixtures.h"

#include <vtkPolyData.h>

#include <fstream>

const char* const SquareScene = R"(#VRML V2.0 utf8
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

void VRMLImporterSource::SetUp()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  this->File = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".wrl");
}

void VRMLImporterSource::TearDown()
{
  std::filesystem::remove_all(this->File);
}

void VRMLImporterSource::Write(const std::string& text)
{
  std::ofstream(this->File, std::ios::binary) << text;
}

void VRMLImporterSource::ExpectError(unsigned long code, const std::string& text)
{
  const std::string error = UpdateAndGetError(this->Reader);
  EXPECT_NE(error.find(text), std::string::npos) << error;
  EXPECT_EQ(this->Reader->GetErrorCode(), code);
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
}
