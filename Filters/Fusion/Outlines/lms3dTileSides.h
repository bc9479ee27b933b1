// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a region along the sides of a tile.
 */
#ifndef lms3dTileSides_h
#define lms3dTileSides_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dFusedTile.h"

/// A ragged border near a side would leave many islands beyond the side, which no straight border
/// could join. Therefore gaps in the cells along a side get May, if they are small and no beam
/// passed there. `region` has all blocks of the tile.
void lms3dCloseGapsAlongSides(const lms3dFusedTile& tile, lms3dRegion& region);

/// Adds the blocks beyond the sides of a tile to the region, without bits, since triangles of the
/// tile may touch them. `region` has the blocks of the tile first, in its order.
void lms3dAddBlocksAround(const lms3dFusedTile& tile, lms3dRegion& region);

#endif
