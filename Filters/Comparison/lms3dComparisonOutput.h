// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fills the outputs of vtkLMS3DMapComparison, whose header names the arrays.
 */
#ifndef lms3dComparisonOutput_h
#define lms3dComparisonOutput_h

#include "Comparison/lms3dComparisonResults.h"
#include "Comparison/lms3dMapComparison.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

/**
 * Adds the errors of vertices and cells to `output`, a shallow copy of the map. `vertexErrors`
 * holds one distance for each point of the map, metres, NaN for a point that is not finite.
 */
void lms3dAddErrors(const lms3dTriangleMesh& map, const lms3dMapErrors& errors,
  const std::vector<double>& vertexErrors, vtkPolyData* output);

/// Writes the visible points of the scene and their errors to `output`.
void lms3dFillScenePoints(const lms3dSceneErrors& errors, vtkPolyData* output);

/// Adds one array for each result. Results on returns that were not measured have no array.
void lms3dAddResults(const lms3dComparisonResults& results, vtkFieldData* output);

#endif
