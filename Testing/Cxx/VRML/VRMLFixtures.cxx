// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VRML/VRMLFixtures.h"

#include "Fixtures/MeshFixtures.h"
#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <fstream>
#include <limits>

const char* const SquareShape =
  "Shape { geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } "
  "coordIndex [ 0 1 2 3 -1 ] } }\n";

std::vector<std::array<lms3dPoint, 3>> GetTriangles(const lms3dScene& scene)
{
  std::vector<std::array<lms3dPoint, 3>> triangles;
  for (const lms3dShape& shape : scene.Shapes)
  {
    for (const std::array<std::int32_t, 3>& triangle : shape.Mesh->Triangles)
    {
      std::array<lms3dPoint, 3> corners;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = shape.ToWorld.Apply(shape.Mesh->Points[triangle[i]]);
      }
      triangles.push_back(corners);
    }
  }
  return triangles;
}

double GetArea(const lms3dScene& scene)
{
  return GetArea(GetTriangles(scene));
}

double GetVolume(const lms3dScene& scene)
{
  double volume = 0.0;
  for (const auto& [a, b, c] : GetTriangles(scene))
  {
    volume += lms3dDot(a, lms3dCross(b, c)) / 6.0;
  }
  return volume;
}

std::array<double, 6> GetBounds(const lms3dScene& scene)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 6> bounds = { far, far, far, -far, -far, -far };
  for (const std::array<lms3dPoint, 3>& triangle : GetTriangles(scene))
  {
    for (const lms3dPoint& corner : triangle)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[axis] = std::min(bounds[axis], corner[axis]);
        bounds[axis + 3] = std::max(bounds[axis + 3], corner[axis]);
      }
    }
  }
  return bounds;
}

std::vector<std::string> GetMessages(const lms3dScene& scene)
{
  std::vector<std::string> texts;
  texts.reserve(scene.Messages.size());
  for (const lms3dMessage& message : scene.Messages)
  {
    texts.push_back((message.Severity == lms3dMessage::MESSAGE_ERROR ? "error " : "warning ") +
      std::to_string(message.Line) + ": " + message.Text);
  }
  return texts;
}

void VRMLScene::SetUp()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  this->Folder = std::filesystem::path(testing::TempDir()) /
    (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::create_directories(this->Folder);
}

void VRMLScene::TearDown()
{
  std::filesystem::remove_all(this->Folder);
}

std::string VRMLScene::Write(const std::string& text, const std::string& name) const
{
  const std::filesystem::path file = this->Folder / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << "#VRML V2.0 utf8\n" << text;
  return file.string();
}

lms3dScene VRMLScene::Read(const std::string& text) const
{
  return lms3dReadVRML(this->Write(text), this->Options, [](double) { return true; });
}
