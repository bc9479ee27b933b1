// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes out loose regions that other triangles make needless.
 */
#ifndef lms3dLooseRegions_h
#define lms3dLooseRegions_h

#include "Fusion/lms3dFusedPlanes.h"

/// Loose regions are facets and triangles of local maps that are regions of their own. One goes if
/// triangles of other regions are within the bound of all of its returns, or if facets for the
/// other returns are fewer than its triangles. The meshes of all planes must be up to date.
void lms3dDropLooseRegions(lms3dFusedPlanes& planes);

#endif
