// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a region at the creases with other planes.
 */
#ifndef lms3dCreaseCut_h
#define lms3dCreaseCut_h

#include "Fusion/lms3dRegionMesher.h"

#include <vector>

/**
 * Takes May from the cells that only a way across a crease joins to a return: a scan from afar guesses surface beyond
 * the crease, and a scan from nearby sees that the surface ends there. Returns keep their cells,
 * and a few cells beyond the crease stay, from which corners move to the crease.
 * `region` is that of lms3dMakeRegion(). Changes its Guess and Covered, too.
 */
void lms3dCutAtCreases(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& region);

#endif
