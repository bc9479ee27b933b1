// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Estimates the noise of ranges before it is known which returns lie on one surface.
 */
#ifndef lms3dScanNoise_h
#define lms3dScanNoise_h

#include "LocalMap/Grid/lms3dRangeGrid.h"

/**
 * Returns the standard deviation of ranges, metres, from the second differences of inverse ranges
 * along fans, as lms3dEstimateNoise does. A tenth of the differences (a quarter of a few) must be
 * as small as noise makes them, so rough ground and small objects do not count as noise. Twice the
 * standard error of the estimate is added. A few thousand beams are sampled. Returns 0 if there are
 * no neighbours.
 *
 * Beams that are `interlaced` beams apart were measured in the same turn of the mirror. Only they
 * are compared, so that a turning platform does not count as noise.
 */
double lms3dEstimateScanNoise(const lms3dRangeGrid& grid, int interlaced);

#endif
