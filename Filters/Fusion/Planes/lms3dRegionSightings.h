// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which scans saw the triangles of a region.
 */
#ifndef lms3dRegionSightings_h
#define lms3dRegionSightings_h

#include "Fusion/Planes/lms3dFusedPlane.h"

/// Sets which scans saw the triangles of a tile of a plane.
void lms3dSetSightings(const lms3dFusedPlane& plane, lms3dFusedTile& tile);

#endif
