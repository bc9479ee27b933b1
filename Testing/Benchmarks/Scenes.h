// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scenes that are timed.
 */
#ifndef Scenes_h
#define Scenes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

struct BenchmarkScene
{
  std::string Name;
  /// Triangles alone.
  vtkSmartPointer<vtkPolyData> Surface;
  std::array<double, 3> Sensor;
  /// Metres, for maps: less where the whole thing is small.
  double DepthStep = 0.1;
};

/// The terrains come last, from the smallest to the largest.
const std::vector<std::string>& GetSceneNames();

/**
 * - room, teapot: Data/NAME.wrl, the sensor inside the one, beside the other;
 * - castle: a closed box with four walls, merlons and round towers of 32 sides, the sensor in the
 * yard;
 *   1,000 triangles, every beam hits;
 * - ball: a ball of 2 m radius and 261,120 triangles, the sensor inside, beside the middle;
 * - terrain1e3 to terrain1e7: 1e3 to 1e7 triangles on 200 m x 200 m of hills, the sensor 2 m above.
 *
 * Throws std::runtime_error where there is no such scene.
 */
BenchmarkScene MakeScene(const std::string& name);

/// Those hills with 100 (2) to 10,000,000 (7) triangles, by the power of ten.
BenchmarkScene MakeTerrain(int power);

#endif
