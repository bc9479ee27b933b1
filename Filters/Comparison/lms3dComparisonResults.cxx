// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dComparisonResults.h"

#include "Comparison/lms3dSurfaceSamples.h"

#include <algorithm>

namespace
{
double GetHarmonicMean(double a, double b)
{
  return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
}
} // namespace

lms3dComparisonResults lms3dSummarize(const lms3dTriangleMesh& map, const lms3dMapErrors& mapErrors,
  const lms3dTriangleMesh& scene, const lms3dSceneErrors& sceneErrors,
  const std::vector<double>& returnDistances, double tolerance)
{
  lms3dComparisonResults results;
  results.MapToScene = lms3dErrorStatistics(mapErrors.Distances);
  results.SceneToMap = lms3dErrorStatistics(sceneErrors.Distances);
  results.NormalError = lms3dErrorStatistics(mapErrors.Angles);

  results.MapTriangles = static_cast<std::int64_t>(map.GetNumberOfTriangles());
  results.MapArea = lms3dGetArea(map);
  results.VisibleArea = sceneErrors.VisibleShare * lms3dGetArea(scene);
  results.AreaInFreeSpace = mapErrors.ShareInFreeSpace * results.MapArea;
  results.ClosedGapAreaInFreeSpace = mapErrors.ShareOfClosedGapsInFreeSpace * results.MapArea;

  results.Correctness = lms3dGetShareWithin(mapErrors.Distances, tolerance);
  results.Completeness = lms3dGetShareWithin(sceneErrors.Distances, tolerance);
  results.FScore = GetHarmonicMean(results.Correctness, results.Completeness);

  if (!returnDistances.empty())
  {
    results.ReturnsWithinTolerance = lms3dGetShareWithin(returnDistances, tolerance);
    results.LargestReturnDistance =
      *std::max_element(returnDistances.begin(), returnDistances.end());
  }
  return results;
}
