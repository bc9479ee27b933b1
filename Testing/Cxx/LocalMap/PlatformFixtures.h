// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans of all platforms, and what holds for the maps of each.
 */
#ifndef PlatformFixtures_h
#define PlatformFixtures_h

#include "LocalMap/MapFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <string>
#include <vector>

/// How the fan is mounted. Mounting is one of vtkLMS3DScanFilter::Mountings.
struct TestPlatform
{
  std::string Name;
  int Mounting = vtkLMS3DScanFilter::YAWING;
  Vector AxisOffset = { 0.0, 0.0, 0.0 };
  double TurnRate = 0.0;

  bool IsFanAlongAxis() const
  {
    return this->Mounting == vtkLMS3DScanFilter::YAWING_TOP ||
      this->Mounting == vtkLMS3DScanFilter::ROLLING;
  }
};

/// Each mounting with the mirror on the axis, beside it in several directions, and with turning
/// platforms.
std::vector<TestPlatform> GetTestPlatforms();

/// A scan of a scene with half a circle of beta, if that measures all directions, in steps of 2
/// degrees.
vtkSmartPointer<vtkPolyData> MakeScan(const MapScene& scene, const TestPlatform& platform);

/// The scan as the mounting Yawing would have measured it, with the same points. The mirror must be
/// on the axis, the fan whole, and half a circle of beta without a turn that repeats the first.
vtkSmartPointer<vtkPolyData> ToYawing(vtkPolyData* scan);

/// The largest distance of a return from the map, metres.
double GetLargestDistance(vtkPolyData* scan, vtkPolyData* map);

double GetField(vtkPolyData* map, const char* name);

#endif
