// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes with a reflectance, and scans that say why beams gave no return.
 */
#ifndef DetectionFixtures_h
#define DetectionFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <vector>

/// Gives each cell a reflectance.
void SetReflectances(
  vtkDataSet* scene, const std::vector<double>& values, const char* name = "Reflectance");

/// Gives all cells of a scene this reflectance.
vtkSmartPointer<vtkPolyData> Paint(vtkSmartPointer<vtkPolyData> scene, double reflectance);

/// A square wall 2 m wide, its middle `distance` along x from the origin. Its normal is turned up
/// by `degrees` from the x axis.
vtkSmartPointer<vtkPolyData> MakeWall(double distance, double degrees = 0.0);

/// A scan of one beam along x.
vtkSmartPointer<vtkLMS3DScanFilter> MakeBeam(vtkDataObject* scene);

/// A scan that sees 10 percent up to 10 m, by the cell array Reflectance, at any range.
void SeeTenPercentAtTenMetres(vtkLMS3DScanFilter* scan);

/// Whether the update gives a return. Fails the test if there is an error.
bool HasReturn(vtkLMS3DScanFilter* scan);

/// The status of all beams in the range image. Fails the test unless the scan's field data has the
/// same.
std::vector<int> GetStatus(vtkLMS3DScanFilter* scan);

#endif
