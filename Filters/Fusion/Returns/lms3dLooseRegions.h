// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes out loose regions that other triangles make needless.
 */
#ifndef lms3dLooseRegions_h
#define lms3dLooseRegions_h

#include "Fusion/Planes/lms3dFusedPlanes.h"

/// Loose regions are facets and triangles of local maps that are regions of their own. One goes if
/// other planes take all of its returns (lms3dCoveringPlanes), or if facets for the other returns
/// are fewer than its triangles. The meshes of all planes must be up to date.
///
/// Only changed meshes can make a region needless, so a region is looked at if a tile near it has
/// `revision` or a later one. `revision` is the number of scans at the last call, 0 at first. A
/// region through whose returns a scan ever saw is always looked at.
void lms3dDropLooseRegions(lms3dFusedPlanes& planes, int revision);

#endif
