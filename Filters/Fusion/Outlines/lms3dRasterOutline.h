// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The outlines of the cells of a raster.
 */
#ifndef lms3dRasterOutline_h
#define lms3dRasterOutline_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Triangulation/lms3dOrientation.h"

#include <vector>

using lms3dLoop = std::vector<lms3dPoint2>;

/// Returns the outlines of the cells with the bit May: counter-clockwise around cells, clockwise
/// around holes. Their corners are corners of cells. Cells that touch at a corner only are apart.
std::vector<lms3dLoop> lms3dTraceOutlines(const lms3dRegion& raster);

/// Whether a loop goes around cells, and not around a hole.
bool lms3dIsAroundCells(const lms3dLoop& loop);

#endif
