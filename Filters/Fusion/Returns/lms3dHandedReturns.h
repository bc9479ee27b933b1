// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hands returns from facets over to the triangles of other planes.
 */
#ifndef lms3dHandedReturns_h
#define lms3dHandedReturns_h

#include "Fusion/Planes/lms3dFusedPlanes.h"

/// Looks at all returns of the weak planes that have a tile of a revision, or no mesh yet. If
/// another plane takes such a return (lms3dCoveringPlanes), it may go to this plane in two cases:
/// at most a facet explains it on its own plane, as beside a crease, or the other plane is at most
/// half as far. The returns of a cell go if all of them may; then the facet of the cell goes, too.
/// A return that the next mesh of the other plane does not cover gets a facet there. A plane that
/// loses its last return goes.
void lms3dHandReturnsOver(lms3dFusedPlanes& planes, int revision);

#endif
