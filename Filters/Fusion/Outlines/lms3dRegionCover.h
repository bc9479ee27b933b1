// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which cells the triangles of a region cover and touch.
 */
#ifndef lms3dRegionCover_h
#define lms3dRegionCover_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dOutlineTriangles.h"

#include <vector>

/// Sets Covered and Touched of the cells that triangles cover and touch. The triangles share their
/// edges, so only the edges around them are looked at.
void lms3dCoverRegion(const std::vector<lms3dTriangle2>& triangles, lms3dRegion& raster);

#endif
