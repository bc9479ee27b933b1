// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane that its region covers, before its borders are straightened.
 */
#ifndef lms3dRegionRaster_h
#define lms3dRegionRaster_h

#include "Fusion/Cells/lms3dRaster.h"

#include <vector>

/// Returns a raster of some of the blocks, in their order, with the bits Must, Far and Passed
/// alone. Must and Far are of sure returns: those without a beam that passed beside them.
lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks);

/// The cells of a region in a block. Must are the sure returns.
struct lms3dRegionCells
{
  lms3dBits May;
  lms3dBits Must;
  lms3dRegionSquares Squares;
};

/**
 * Returns the cells of a region in a block. Cells that are nearer to a return than to a beam that
 * passed belong to the region if a local map has surface there, or if they lie in a narrow gap
 * between such cells. Cells that are nearer to a beam that passed do not. Where neither is near,
 * the region is where a local map has surface, apart from places between beams that all passed.
 * The result depends on cells at most lms3dCellWindow::Reach away alone.
 */
lms3dRegionCells lms3dMakeRegionCells(const lms3dRaster& raster, int number);

/// Marks the blocks whose lms3dRegionCells may change, since cells near them changed, as dirty.
/// Forgets the changes.
void lms3dMarkDependents(lms3dRaster& raster);

#endif
