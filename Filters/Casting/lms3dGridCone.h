// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compares a part of a scan's grid with the cone of directions in which the scene lies.
 */
#ifndef lms3dGridCone_h
#define lms3dGridCone_h

#include "Casting/lms3dBeamGrid.h"
#include "Casting/lms3dGridCaster.h"
#include "Kernels/lms3dPacketKernels.h"

/// Returns whether all beams of a rectangle lie outside the cone. Looks at each turn and each beam,
/// but not at each pair of them.
bool lms3dIsOutside(
  const lms3dCone& cone, const lms3dBeamGrid& grid, const lms3dPacketRectangle& rectangle);

#endif
