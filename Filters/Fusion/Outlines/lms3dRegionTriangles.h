// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Straightens the borders of a region, and divides it into triangles.
 */
#ifndef lms3dRegionTriangles_h
#define lms3dRegionTriangles_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Outlines/lms3dFusedTile.h"
#include "Fusion/Outlines/lms3dOutlineTriangles.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <vector>

/// Borders move to creases, and are straightened within a tolerance, as far as triangles can be
/// made of them. They may cut off returns within a reach. Both are in cells. `outlines` are what
/// lms3dTraceOutlines() returns. `region` has the bits of lms3dCopySureReturns().
std::vector<lms3dTriangle2> lms3dTriangulateRegion(const std::vector<lms3dLoop>& outlines,
  const lms3dRegion& region, const std::vector<lms3dCreaseLine>& creases,
  const lms3dFusedTile& tile, double tolerance, double reach);

#endif
