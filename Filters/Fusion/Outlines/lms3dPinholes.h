// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins small holes of a region with what lies outside of it.
 */
#ifndef lms3dPinholes_h
#define lms3dPinholes_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dFusedTile.h"

/// The surface goes some cells beyond the last returns, and beams that pass beside an object leave
/// small holes there. A hole needs two triangles more than it has corners. Therefore cells lose May
/// if they lie between a cell that a beam passed and the outside, along an axis, and if there are
/// few of them and no return among them. `region` has all blocks of the tile.
void lms3dOpenPinholes(const lms3dFusedTile& tile, lms3dRegion& region);

#endif
