// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves the corners of outlines to creases.
 */
#ifndef lms3dCreaseSnapping_h
#define lms3dCreaseSnapping_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Outlines/lms3dFusedTile.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <vector>

/// Moves corners near a crease to its line, and corners near two to the point in which their lines
/// meet. A corner stays if a beam passed between its old and its new place, or if the border would
/// move away from returns. Removes corners that coincide with the one before, and spikes. Corners
/// on a side of the tile stay on it, and corners within a distance, cells, of one of some places
/// stay where they are. `isFixed` receives which corners lie on creases or on sides of the tile.
std::vector<lms3dLoop> lms3dSnapToCreases(const std::vector<lms3dLoop>& loops,
  const std::vector<lms3dCreaseLine>& creases, const lms3dRegion& region,
  const lms3dFusedTile& tile, const std::vector<lms3dPoint2>& places, double distance,
  std::vector<bool>& isFixed);

#endif
