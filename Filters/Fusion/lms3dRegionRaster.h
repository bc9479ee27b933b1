// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane that its region covers, before its borders are straightened.
 */
#ifndef lms3dRegionRaster_h
#define lms3dRegionRaster_h

#include "Fusion/lms3dRaster.h"

#include <vector>

/// Returns blocks of a raster with their eight neighbours, in order.
std::vector<int> lms3dFindBlocksAround(const lms3dRaster& raster, const std::vector<int>& blocks);

/// Returns the blocks whose shape is made anew, in order. Up to 15 cells at the side of another
/// block could change, too; they wait until that block is marked.
std::vector<int> lms3dFindDirtyBlocks(const lms3dRaster& raster);

/// Returns a raster of some of the blocks, in their order. `May` are the cells of the region: where
/// a local map has surface and no beam passed, and where returns lie. `Must` are the returns that
/// no border may cut off: those without a beam that passed beside them. `Passed` are the cells
/// where a beam passed. A block depends on its eight neighbours alone.
lms3dRegion lms3dMakeRegion(const lms3dRaster& raster, const std::vector<int>& blocks);

/// The same with the bits Must and Passed alone.
lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks);

#endif
