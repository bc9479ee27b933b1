// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The numbers that a comparison yields. vtkLMS3DMapComparison.h defines each of them.
 */
#ifndef lms3dComparisonResults_h
#define lms3dComparisonResults_h

#include "Comparison/lms3dErrorStatistics.h"
#include "Comparison/lms3dMapComparison.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <cstdint>
#include <limits>
#include <vector>

/// Lengths in metres, areas in square metres, shares from 0 to 1. NaN: not measured.
struct lms3dComparisonResults
{
  lms3dErrorStatistics MapToScene;
  lms3dErrorStatistics SceneToMap;
  /// Degrees.
  lms3dErrorStatistics NormalError;

  std::int64_t MapTriangles = 0;
  double MapArea = std::numeric_limits<double>::quiet_NaN();
  double VisibleArea = std::numeric_limits<double>::quiet_NaN();
  double AreaInFreeSpace = std::numeric_limits<double>::quiet_NaN();
  double ClosedGapAreaInFreeSpace = std::numeric_limits<double>::quiet_NaN();

  double Correctness = std::numeric_limits<double>::quiet_NaN();
  double Completeness = std::numeric_limits<double>::quiet_NaN();
  double FScore = std::numeric_limits<double>::quiet_NaN();

  double ReturnsWithinTolerance = std::numeric_limits<double>::quiet_NaN();
  double LargestReturnDistance = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Summarizes the errors of both surfaces. `returnDistances` are the distances of the scan's returns
 * from the map, metres; an empty list leaves the two results on returns NaN.
 */
lms3dComparisonResults lms3dSummarize(const lms3dTriangleMesh& map, const lms3dMapErrors& mapErrors,
  const lms3dTriangleMesh& scene, const lms3dSceneErrors& sceneErrors,
  const std::vector<double>& returnDistances, double tolerance);

#endif
