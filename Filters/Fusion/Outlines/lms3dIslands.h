// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins parts of a region that are near each other.
 */
#ifndef lms3dIslands_h
#define lms3dIslands_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <vector>

/// Few beams of each scan meet a thing such as the leg of a chair, so that its region falls into
/// islands around returns. Each island needs triangles of its own. Therefore two islands are joined
/// by a narrow bridge of cells with May, if they are at most 32 cells apart. No beam passed where
/// the bridge is, no cell of it has Open in the raster, and it crosses no crease. The nearest
/// islands are joined first. The bridges lie in blocks of the region. `outlines` are what
/// lms3dTraceOutlines() returns. Returns whether there are bridges.
bool lms3dJoinIslands(const std::vector<lms3dLoop>& outlines, const lms3dRaster& raster,
  const std::vector<lms3dCreaseLine>& creases, lms3dRegion& region);

#endif
