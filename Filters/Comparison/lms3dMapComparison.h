// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a local map gets wrong: its distances to the scene that was scanned, and back.
 */
#ifndef lms3dMapComparison_h
#define lms3dMapComparison_h

#include "Comparison/lms3dSensorView.h"
#include "Comparison/lms3dSurfaceQuery.h"
#include "Comparison/lms3dSurfaceSamples.h"

#include <cstdint>
#include <vector>

/// The map, sampled.
struct lms3dMapErrors
{
  lms3dMapErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
    const lms3dSensorView& view, double tolerance, std::int64_t count);

  lms3dSurfaceSamples Samples;

  /// For each sample the distance to the scene, metres.
  std::vector<double> Distances;

  /**
   * For each sample the angle, degrees, between its triangle and the scene's nearest, 0 to 90; where
   * the sensor sees the back of the map's triangle, 180 less that.
   */
  std::vector<double> Angles;

  /// The share of samples that the view covers, beyond the tolerance, and as much nearer to the
  /// sensor than the scene is along their beam: what the sensor has seen to be empty.
  double ShareInFreeSpace;
};

/// The part of the scene that the sensor sees, sampled.
struct lms3dSceneErrors
{
  /**
   * Samples the scene so finely that about `count` of its samples are seen, or, where little is
   * seen, with 32 times as many.
   */
  lms3dSceneErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
    const lms3dSensorView& view, std::int64_t count);

  /// Those of the samples that the view covers and that nothing hides.
  lms3dSurfaceQuery::Points Points;

  /// The share of the whole scene's area.
  double VisibleShare;

  /// For each point the distance to the map, metres.
  std::vector<double> Distances;
};

/// The distances of some points from a surface, metres.
std::vector<double> lms3dGetDistances(
  const lms3dSurfaceQuery& surface, const lms3dSurfaceQuery::Points& points);

#endif
