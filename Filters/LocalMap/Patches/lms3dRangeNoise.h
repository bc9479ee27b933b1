// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Estimates the noise of ranges from the scan itself.
 */
#ifndef lms3dRangeNoise_h
#define lms3dRangeNoise_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <vector>

/**
 * Returns the standard deviation of ranges, metres. On a plane, three consecutive inverse ranges w
 * of a column satisfy w[i-1] + w[i+1] = 2 cos(step) w[i]. The residual of that equation, times the
 * squared range, has six times the variance of the noise. The median of the residuals is robust
 * against creases and depth steps. Returns 0 if no three consecutive beams returned. Filled beams
 * (lms3dRangeGrid) do not count. Uses the threads of the calling TBB arena.
 */
double lms3dEstimateNoise(const lms3dBeamSphere& sphere);

/// The same from the absolute values of residuals, metres. Changes their order.
double lms3dGetNoiseOfResiduals(std::vector<double>& residuals);

#endif
