// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether the returns of a column are near a triangle, along their beams.
 */
#ifndef lms3dColumnDeviations_h
#define lms3dColumnDeviations_h

#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

/**
 * The deviation of a return is the distance along its beam, metres, to the plane of a triangle. At
 * a pole, half of the spread of its returns (lms3dBeamSphere::GetPoleHalfSpread) is added.
 *
 * Returns true only if all deviations of a column from one row to another, both included, are
 * within the limit, metres. Entries without a return count as returns at range 0. Beams must be
 * regular. Takes no division; rounding can make it return false.
 */
bool lms3dAreWithin(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane, int column,
  int firstRow, int lastRow, double limit);

#endif
