// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes of triangles that are hard to map, with a sensor in each.
 */
#ifndef MapScenes_h
#define MapScenes_h

#include "Fixtures/CasterFixtures.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

struct MapScene
{
  vtkSmartPointer<vtkPolyData> Surface;
  Vector Position = { 0.0, 0.0, 0.0 };
  Vector Orientation = { 0.0, 0.0, 0.0 };
  /// Whether all beams return from one continuous surface.
  bool IsWhole = false;
  double MaximumRange = 80.0;
  std::array<double, 2> AlphaRange = { -90.0, 90.0 };
  std::array<double, 2> BetaRange = { 0.0, 360.0 };
  int AlphaResolution = 91;
  int BetaResolution = 90;
};

/// Throws std::runtime_error for a name that GetMapSceneNames() does not contain.
MapScene MakeMapScene(const std::string& name);
std::vector<std::string> GetMapSceneNames();

/// A room with up to six boxes, balls and plates in it, and any pose and resolution.
MapScene MakeRandomMapScene(Random& random);

#endif
