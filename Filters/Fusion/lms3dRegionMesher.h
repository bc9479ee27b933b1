// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the triangles of a tile of a fused map.
 */
#ifndef lms3dRegionMesher_h
#define lms3dRegionMesher_h

#include "Fusion/lms3dCreaseLine.h"
#include "Fusion/lms3dFusedPlane.h"

#include <vector>

/// How many cells away from a return a covered cell may be, so that the return is within the bound:
/// 0 or 1. `deviation` is the return's distance from the plane; all lengths are in metres.
int lms3dGetCoveredReach(double deviation, double cell, double maximumError);

/// Replaces the mesh of a tile, but not its sightings. Changes blocks of this tile alone, and looks
/// at Passed of blocks beside it. `maximumError` is in metres.
void lms3dMakeTileMesh(lms3dFusedPlane& plane, lms3dFusedTile& tile,
  const std::vector<lms3dCreaseLine>& creases, double maximumError);

#endif
