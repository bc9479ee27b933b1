// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Errors of a local map at sample points: the distances from map to scene, and back.
 */
#ifndef lms3dMapComparison_h
#define lms3dMapComparison_h

#include "Comparison/lms3dClosedBeams.h"
#include "Comparison/lms3dSensorView.h"
#include "Comparison/lms3dSurfaceQuery.h"
#include "Comparison/lms3dSurfaceSamples.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <vector>

// Everything here throws lms3dBuildStopped if `progress` stopped it.

/// Errors at samples of the map.
struct lms3dMapErrors
{
  /// Takes `count` samples, at least 1. `tolerance` is in metres.
  lms3dMapErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
    const lms3dSensorView& view, const lms3dClosedBeams& closedBeams, double tolerance,
    std::int64_t count, const lms3dProgress& progress);

  lms3dSurfaceSamples Samples;

  /// The distance of each sample from the scene, metres.
  std::vector<double> Distances;

  /**
   * For each sample the angle between the planes of its triangle and of the nearest triangle of the
   * scene, degrees, 0 to 90. If the map's triangle faces away from the sensor, 180 minus this
   * angle.
   */
  std::vector<double> Angles;

  /// The share of samples in space that the sensor has seen to be empty: the view covers them, they
  /// are farther than the tolerance from the scene, and they are nearer to the sensor than the
  /// scene along their beam by more than the tolerance. Samples in closed gaps have a share of
  /// their own.
  double ShareInFreeSpace;
  double ShareOfClosedGapsInFreeSpace;
};

/// Errors at samples of the visible scene.
struct lms3dSceneErrors
{
  /**
   * Samples the scene so densely that about `count` samples are visible. The scene gets at most
   * 32 * `count` samples, so there are fewer visible ones if the sensor sees less than 1/32 of the
   * scene.
   */
  lms3dSceneErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
    const lms3dSensorView& view, std::int64_t count, const lms3dProgress& progress);

  /// The samples that the view covers and that no part of the scene hides. May be empty.
  lms3dSurfaceQuery::Points Points;

  /// The visible share of the scene's area.
  double VisibleShare;

  /// The distance of each point from the map, metres.
  std::vector<double> Distances;
};

/// Returns the distance of each point from the surface, metres; infinite for a point that is not
/// finite.
std::vector<double> lms3dGetDistances(const lms3dSurfaceQuery& surface,
  const lms3dSurfaceQuery::Points& points, const lms3dProgress& progress);

#endif
