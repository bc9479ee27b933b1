// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a block of a raster knows of the triangles of its tile.
 */
#ifndef lms3dMeshedBlock_h
#define lms3dMeshedBlock_h

#include "Fusion/Cells/lms3dRaster.h"

/// Notes that a mesh of the block's Shape has been made: what it covers and touches, and whether it
/// has surface beyond the Shape. `cells` is the block of the region that has been triangulated.
void lms3dNoteMesh(const lms3dRegionBlock& cells, lms3dRasterBlock& block);

#endif
