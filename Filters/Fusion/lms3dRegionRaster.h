// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a plane that its region covers, before its borders are straightened.
 */
#ifndef lms3dRegionRaster_h
#define lms3dRegionRaster_h

#include "Fusion/lms3dRaster.h"

/// Returns a raster with the same blocks. `May` are the cells of the region: where a local map has surface and no beam
/// passed, and where returns lie. `Must` are the returns that no border may cut off: those without a beam that
/// passed beside them. `Passed` are the cells where a beam passed. `Open` is empty.
lms3dRaster lms3dMakeRegion(const lms3dRaster& raster);

#endif
