// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane that its region covers, before its borders are straightened.
 */
#ifndef lms3dRegionRaster_h
#define lms3dRegionRaster_h

#include "Fusion/lms3dDisputedCells.h"
#include "Fusion/lms3dRaster.h"

#include <vector>

/// Returns the cells of a block with returns that no border may cut off: those without a beam that
/// passed beside them.
lms3dBits lms3dGetSureReturns(const lms3dRaster& raster, const lms3dRasterBlock& block);

/// Returns a raster of some of the blocks, in their order, with the bits Must and Passed alone.
/// Must are the sure returns.
lms3dRegion lms3dCopySureReturns(const lms3dRaster& raster, const std::vector<int>& blocks);

/// The cells of a region in a block: May are those where a local map has surface and no beam
/// passed, and where returns lie, Must are the sure returns. They depend on the block and its eight
/// neighbours alone.
struct lms3dRegionCells
{
  lms3dBits May;
  lms3dBits Must;
};

lms3dRegionCells lms3dMakeRegionCells(
  const lms3dRaster& raster, int number, const lms3dDisputedCells& disputed);

#endif
