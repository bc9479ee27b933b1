// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the triangles of a tile of a fused map.
 */
#ifndef lms3dRegionMesher_h
#define lms3dRegionMesher_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Planes/lms3dFusedPlane.h"

#include <vector>

/// Replaces the mesh of a tile, but not its sightings. Changes blocks of this tile alone, and looks
/// at Passed of blocks beside it. `maximumError` is in metres.
void lms3dMakeTileMesh(lms3dFusedPlane& plane, lms3dFusedTile& tile,
  const std::vector<lms3dCreaseLine>& creases, double maximumError);

#endif
