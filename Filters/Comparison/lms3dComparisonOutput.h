// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The outputs of vtkLMS3DMapComparison, filled from the errors that were found.
 */
#ifndef lms3dComparisonOutput_h
#define lms3dComparisonOutput_h

#include "Comparison/lms3dMapComparison.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

/// Adds the errors of the map's vertices and cells to a copy of the map.
void lms3dAddErrors(const lms3dTriangleMesh& map, const lms3dMapErrors& errors,
  const std::vector<double>& vertexErrors, vtkPolyData* output);

/// Makes the visible points of the scene with their errors.
void lms3dFillScenePoints(const lms3dSceneErrors& errors, vtkPolyData* output);

/// Adds what all errors come to, under the names in vtkLMS3DMapComparison.h; `returnDistances` may
/// be empty.
void lms3dAddResults(const lms3dTriangleMesh& map, const lms3dMapErrors& mapErrors,
  const lms3dTriangleMesh& scene, const lms3dSceneErrors& sceneErrors,
  const std::vector<double>& returnDistances, double tolerance, vtkFieldData* results);

#endif
