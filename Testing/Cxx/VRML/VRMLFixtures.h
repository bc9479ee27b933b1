// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Writes scenes, reads them with the VRML97 reader and measures the result.
 */
#ifndef VRMLFixtures_h
#define VRMLFixtures_h

#include "Shapes/lms3dVRMLReader.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// A Shape: a square of 1 m in the xy plane, with a corner at the origin.
extern const char* const SquareShape;

/// The corners of all triangles of a scene, in world coordinates.
std::vector<std::array<lms3dPoint, 3>> GetTriangles(const lms3dScene& scene);

double GetArea(const lms3dScene& scene);
/// The enclosed volume of a closed surface, positive if its triangles face outwards.
double GetVolume(const lms3dScene& scene);
/// xmin, ymin, zmin, xmax, ymax, zmax.
std::array<double, 6> GetBounds(const lms3dScene& scene);

/// Returns each message as "error 3: text", with its line.
std::vector<std::string> GetMessages(const lms3dScene& scene);

/// Each test has its own folder.
class VRMLScene : public testing::Test
{
protected:
  void SetUp() override;
  void TearDown() override;

  /// Writes a file: the header, which is its first line, and the text. Returns its path.
  std::string Write(const std::string& text, const std::string& name = "scene.wrl") const;
  lms3dScene Read(const std::string& text) const;

  std::filesystem::path Folder;
  lms3dVRMLOptions Options;
};

#endif
