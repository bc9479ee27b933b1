// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Trajectories, and a scan along one.
 */
#ifndef TrajectoryFixtures_h
#define TrajectoryFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

extern const std::vector<Point> ThreePositions;

vtkSmartPointer<vtkPolyData> MakePoses(const std::vector<Point>& positions);

/// Adds a polyline through the points of these ids.
void AddLine(vtkPolyData* poses, const std::vector<vtkIdType>& order);

/// Adds an array to the points.
void AddArray(
  vtkPolyData* poses, const char* name, int components, const std::vector<double>& values);

/// Scans a ball along a trajectory.
vtkSmartPointer<vtkLMS3DScanFilter> MakeScanAlong(vtkPolyData* poses);

/// The time steps that an output offers.
std::vector<double> GetTimes(vtkLMS3DScanFilter* scan, int port = 0);

#endif
