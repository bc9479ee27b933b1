// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes out what a local map guesses behind its own surfaces.
 */
#ifndef lms3dHiddenGuesses_h
#define lms3dHiddenGuesses_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dLocalMap.h"
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <vector>

/**
 * A patch of a local map may end anywhere between two beams. At grazing incidence this is metres
 * behind the surface that the next beam meets. Therefore a guess between four beams goes where it
 * lies far behind the plane of one of their returns, unless the patch of the guess has a return
 * around them that lies behind this plane, too.
 *
 * Clears bits of Guess alone. `planeOfPatch` has -1 for a patch without a plane.
 */
void lms3dTakeOutHiddenGuesses(const lms3dLocalMap& local, const lms3dSeenRanges& ranges,
  const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes);

#endif
