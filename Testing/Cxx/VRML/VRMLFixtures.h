// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes that are written by a test and read by the VRML97 reader.
 */
#ifndef VRMLFixtures_h
#define VRMLFixtures_h

#include "Shapes/lms3dVRMLReader.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// A square of one metre with its corner at the origin, in the plane of x and y.
extern const char* const SquareShape;

/// Corners of all triangles of a scene, in world coordinates.
std::vector<std::array<lms3dPoint, 3>> GetTriangles(const lms3dScene& scene);

double GetArea(const lms3dScene& scene);
/// What the triangles enclose, positive where they face outwards.
double GetVolume(const lms3dScene& scene);
/// xmin, ymin, zmin, xmax, ymax, zmax.
std::array<double, 6> GetBounds(const lms3dScene& scene);

/// "error 3: words" for each message.
std::vector<std::string> GetMessages(const lms3dScene& scene);

/// A folder of the test's own.
class VRMLScene : public testing::Test
{
protected:
  void SetUp() override;
  void TearDown() override;

  /// Writes a file after the header, which is its first line.
  std::string Write(const std::string& text, const std::string& name = "scene.wrl") const;
  lms3dScene Read(const std::string& text) const;

  std::filesystem::path Folder;
  lms3dVRMLOptions Options;
};

#endif
