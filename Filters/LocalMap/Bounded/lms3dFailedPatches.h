// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gives the returns of patches that cannot be meshed other patches.
 */
#ifndef lms3dFailedPatches_h
#define lms3dFailedPatches_h

#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include <vector>

/**
 * Lets the uncovered returns of the meshes leave their patches. Divides each other patch that
 * failed into four parts or, if it is small, gives each of its returns a patch. A return that is
 * alone in its patch moves to the largest patch on the same surface beside it, once; without one,
 * and the second time, it loses its patch. Then its facet leaves a hole in the surface around it.
 * Beams must be regular. `members` and `failed` belong to the patches.
 */
void lms3dDivideFailedPatches(const lms3dBeamSphere& sphere, const std::vector<int>& members,
  const std::vector<bool>& failed, const std::vector<lms3dPatchMesh>& meshes,
  lms3dPatches& patches);

#endif
