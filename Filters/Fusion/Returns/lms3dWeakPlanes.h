// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Replaces planes of few returns by better ones.
 */
#ifndef lms3dWeakPlanes_h
#define lms3dWeakPlanes_h

#include "Fusion/Planes/lms3dFusedPlanes.h"

/// A weak plane near surface that the last scan added goes if other planes show at least half of
/// its returns, and if facets for the rest are fewer than its triangles. The rest get facets, which
/// are weak, too.
void lms3dDissolveWeakPlanes(lms3dFusedPlanes& planes);

#endif
