// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hands returns from facets over to the triangles of other planes.
 */
#ifndef lms3dHandedReturns_h
#define lms3dHandedReturns_h

#include "Fusion/lms3dFusedPlanes.h"

/// If the triangles of a weak plane do not explain the returns in a cell, the cell has a facet.
/// Where triangles of other planes explain all of these returns, as beside a crease, the returns
/// go to the other planes, and the facet goes. Looks at the tiles that have a revision. The meshes
/// of all planes must be up to date.
void lms3dHandReturnsOver(lms3dFusedPlanes& planes, int revision);

#endif
