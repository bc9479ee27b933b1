// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The creases at which planes of a fused map meet.
 */
#ifndef lms3dCreases_h
#define lms3dCreases_h

#include "Fusion/Cells/lms3dCreaseLine.h"
#include "Fusion/Planes/lms3dFusedPlanes.h"

#include <vector>

/// Adds the edges between patches of a local map to the creases of their planes. `planeOfPatch` has
/// the plane of each patch, -1 for none.
void lms3dAddCreases(
  const lms3dLocalMap& local, const std::vector<int>& planeOfPatch, lms3dFusedPlanes& planes);

/// The creases of a plane, in its frame.
std::vector<lms3dCreaseLine> lms3dGetCreaseLines(const lms3dFusedPlanes& planes, int number);

#endif
