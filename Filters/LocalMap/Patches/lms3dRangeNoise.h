// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tells the noise of ranges from the scan itself.
 */
#ifndef lms3dRangeNoise_h
#define lms3dRangeNoise_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

/**
 * The standard deviation of ranges, metres. On any plane neighbours w of 1/range in a column obey
 * w[i-1] + w[i+1] = 2 cos(step) w[i], so what is left of that, times the range squared, is noise of
 * six times its variance; its median is little moved by creases and steps. 0 where no three returns
 * follow each other.
 */
double lms3dEstimateNoise(const lms3dBeamSphere& sphere);

#endif
