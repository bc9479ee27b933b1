// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Closes small holes of a region through which no beam passed.
 */
#ifndef lms3dSmallHoles_h
#define lms3dSmallHoles_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <vector>

/// A thing that stands on a plane, such as the leg of a table, hides a part of the plane, so that
/// the region has a hole. The corners of each hole need triangles. Therefore holes of at most 32
/// cells along both axes get May, unless an island lies in the hole, a beam passed through a cell
/// of it, or a cell has Open in the raster. `outlines` come from lms3dTraceOutlines(). The outline
/// of each hole that is closed is removed.
///
/// A hole is closed even if a crease crosses it.
void lms3dCloseSmallHoles(
  const lms3dRaster& raster, std::vector<lms3dLoop>& outlines, lms3dRegion& region);

#endif
