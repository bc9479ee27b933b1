// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which returns are too weak for the device, by vtkLMS3DScanFilter's RangeAtTenPercent.
 */
#ifndef lms3dWeakReturns_h
#define lms3dWeakReturns_h

#include "Scan/lms3dSurfaceAttributes.h"

#include <vector>

/**
 * Returns 1 for each beam of the grid that hits a triangle and sends too little light back to the
 * device, otherwise 0: reflectance times the cosine of the incidence is below
 * max(0.018, 0.1 (range / rangeAtTenPercent)^2). `ranges` has the range of each beam, metres.
 * `rangeAtTenPercent`, metres, is above 0. Uses the threads of the calling TBB arena.
 */
std::vector<unsigned char> lms3dFindWeakReturns(
  const lms3dSurfaceHits& hits, const double* ranges, double rangeAtTenPercent);

#endif
