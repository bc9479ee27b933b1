// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where a corner near creases goes.
 */
#ifndef lms3dCreasePlaces_h
#define lms3dCreasePlaces_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Outlines/lms3dFusedTile.h"
#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <optional>
#include <vector>

/// Returns the point of the nearest crease for a corner near it, or the point in which the two
/// nearest meet. A corner on a side of the tile stays on it. Returns none if no crease is near.
std::optional<lms3dPoint2> lms3dFindPlaceOnCrease(const lms3dPoint2& point,
  const std::vector<lms3dCreaseLine>& creases, const lms3dFusedTile& tile);

/// Returns the creases that may be near a corner of outlines, in their order.
std::vector<lms3dCreaseLine> lms3dFindCreasesNear(
  const std::vector<lms3dLoop>& outlines, const std::vector<lms3dCreaseLine>& creases);

#endif
