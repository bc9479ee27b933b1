// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gives the blocks of a plane to tiles.
 */
#ifndef lms3dPlaneTiles_h
#define lms3dPlaneTiles_h

#include "Fusion/Planes/lms3dFusedPlane.h"

#include <vector>

/// Gives new blocks to tiles. New tiles are added to `regions`.
void lms3dAddTiles(lms3dFusedPlane& plane, std::vector<const lms3dFusedTile*>& regions);

#endif
