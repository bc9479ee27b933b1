// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the triangles of a region of a fused map.
 */
#ifndef lms3dRegionMesher_h
#define lms3dRegionMesher_h

#include "Fusion/lms3dFusedPlane.h"

#include <vector>

/// A crease in the frame of a plane: a line, and the parts of it at which the other plane ends. Coordinates are cells.
struct lms3dCreaseLine
{
  lms3dPoint2 Point;
  /// With length 1.
  lms3dPoint2 Direction;
  /// Along the direction from the point.
  lms3dCreaseParts Parts;
};

/// How many cells away from a return a covered cell may be, so that the return is within the bound: 0 or 1.
/// `deviation` is the return's distance from the plane; all lengths are in metres.
int lms3dGetCoveredReach(double deviation, double cell, double maximumError);

/// Replaces the mesh of a plane, but not its sightings. `maximumError` is in metres.
void lms3dMakeRegionMesh(
  lms3dFusedPlane& plane, const std::vector<lms3dCreaseLine>& creases, double maximumError);

#endif
