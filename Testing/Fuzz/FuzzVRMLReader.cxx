// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads any bytes with the VRML97 reader, for libFuzzer and for the test of its corpus.
 */
#include "FuzzVRMLReader.h"

#include "Shapes/lms3dVRMLReader.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{
namespace fs = std::filesystem;

// Small limits, so that large scenes end soon.
lms3dVRMLOptions GetOptions()
{
  lms3dVRMLOptions options;
  options.ChordError = 0.05;
  options.MaximumInlineDepth = 4;
  options.MaximumNumberOfNodes = 20000;
  options.MaximumNumberOfTriangles = 100000;
  options.MaximumMemory = 1 << 28;
  options.MaximumFileSize = 1 << 22;
  return options;
}

void Write(const fs::path& file, const char* data, std::size_t size)
{
  std::ofstream(file, std::ios::binary).write(data, static_cast<std::streamsize>(size));
}

void Require(bool isTrue)
{
  if (!isTrue)
  {
    std::abort();
  }
}

void CheckMesh(const lms3dShape& shape)
{
  const lms3dMesh& mesh = *shape.Mesh;
  Require(mesh.Colors.empty() || mesh.Colors.size() == mesh.Triangles.size());
  for (const std::array<std::int32_t, 3>& triangle : mesh.Triangles)
  {
    for (std::int32_t corner : triangle)
    {
      Require(corner >= 0 && static_cast<std::size_t>(corner) < mesh.Points.size());
    }
  }
  for (const lms3dPoint& point : mesh.Points)
  {
    for (double coordinate : shape.ToWorld.Apply(point))
    {
      Require(std::isfinite(coordinate));
    }
  }
}
} // namespace

lms3dFuzzFolder::lms3dFuzzFolder(const fs::path& folder)
  : Folder(folder)
{
  const std::string library = "#VRML V2.0 utf8\n"
                              "PROTO P [ field SFVec3f size 1 1 1 field MFNode children [ ] ] {\n"
                              "  Group { children [ Shape { geometry Box { size IS size } }\n"
                              "    Group { children IS children } ] } }\n"
                              "PROTO Q [ ] { Inline { url \"input.wrl\" } }\n"
                              "DEF S Shape { geometry Sphere { } }\n";
  fs::create_directories(this->Folder);
  Write(this->Folder / "library.wrl", library.data(), library.size());
}

lms3dFuzzFolder::~lms3dFuzzFolder()
{
  std::error_code error;
  fs::remove_all(this->Folder, error);
}

void lms3dFuzzFolder::Read(const char* data, std::size_t size) const
{
  const fs::path input = this->Folder / "input.wrl";
  Write(input, data, size);
  const lms3dScene scene = lms3dReadVRML(input.string(), GetOptions(), [](double) { return true; });
  for (const lms3dShape& shape : scene.Shapes)
  {
    CheckMesh(shape);
  }
}
