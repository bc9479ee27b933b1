// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves the corners of outlines to creases.
 */
#ifndef lms3dCreaseSnapping_h
#define lms3dCreaseSnapping_h

#include "Fusion/lms3dRasterOutline.h"
#include "Fusion/lms3dRegionMesher.h"

#include <vector>

/// Moves corners near a crease to its line, and corners near two to the point in which their lines meet. A corner
/// stays if a beam passed between its old and its new place. Removes corners that coincide with the one before, and
/// spikes. `isFixed` receives which corners lie on creases.
std::vector<lms3dLoop> lms3dSnapToCreases(const std::vector<lms3dLoop>& loops,
  const std::vector<lms3dCreaseLine>& creases, const lms3dRaster& region,
  std::vector<bool>& isFixed);

#endif
