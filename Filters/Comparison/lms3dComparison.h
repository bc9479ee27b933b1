// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compares a map with its scene and fills the outputs: the steps of vtkLMS3DMapComparison.
 */
#ifndef lms3dComparison_h
#define lms3dComparison_h

#include "Comparison/lms3dComparisonResults.h"
#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Pipeline/lms3dProgress.h"

class lms3dSurfaceQuery;
class vtkPolyData;

struct lms3dComparison
{
  /// The map, and the scan that it was made from or null. Neither is changed.
  vtkPolyData* Map;
  vtkPolyData* Scan;

  /// Metres.
  double Tolerance;
  int NumberOfSamples;
  lms3dRangeLimits Limits;

  /// Throws std::runtime_error with a message for the user if a number is out of its range.
  void Check() const;

  /**
   * Fills both outputs, and sets the results. `map` and `scene` are the triangles of both surfaces,
   * at least one in each, all with an area. Returns false, and leaves outputs and results as they
   * are, if `progress` stops the work. Throws std::runtime_error with a message for the user if the
   * pose is missing or the sensor sees nothing of the scene. Uses the threads of the calling TBB
   * arena.
   */
  bool Run(lms3dTriangleMesh map, lms3dTriangleMesh scene, const lms3dProgress& progress,
    vtkPolyData* mapWithErrors, vtkPolyData* scenePoints, lms3dComparisonResults& results) const;

private:
  bool Compare(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
    const lms3dProgress& progress, vtkPolyData* mapWithErrors, vtkPolyData* scenePoints,
    lms3dComparisonResults& results) const;
};

#endif
