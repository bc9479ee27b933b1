// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which returns of a pole one vertex can represent.
 */
#ifndef lms3dPoleRanges_h
#define lms3dPoleRanges_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <vector>

/**
 * The beams of all turns coincide at a pole, so their returns become one vertex. Gives each pole of the
 * sphere the range that a vertex must have to be within `maximumError`, metres, of as many returns as
 * possible: of all returns if their ranges span at most twice that, otherwise of the
 * returns within `maximumError` of the median. See lms3dBeamSphere::SetPole().
 *
 * Returns the nearest and the farthest return of each pole, in the sensor frame, metres. The largest
 * deviation of a pole belongs to one of these.
 */
std::vector<lms3dVector> lms3dSetPoleRanges(
  const lms3dRangeGrid& grid, double maximumError, lms3dBeamSphere& sphere);

#endif
