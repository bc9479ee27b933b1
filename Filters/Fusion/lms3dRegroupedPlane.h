// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes a plane of returns that were grouped anew.
 */
#ifndef lms3dRegroupedPlane_h
#define lms3dRegroupedPlane_h

#include "Fusion/lms3dBeamTable.h"
#include "Fusion/lms3dFusedPlanes.h"
#include "Fusion/lms3dReturnGroups.h"

#include <vector>

/// Returns the number of a new, weak plane with the returns of a group. It has surface between
/// neighbouring beams that meet it, and where triangles of the old planes are within the bound of
/// it. Each scan of a return must have a table, which says which of its beams are neighbours.
int lms3dMakeRegroupedPlane(const std::vector<lms3dMappedReturn>& returns,
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes,
  const lms3dTablesOfScans& tables, lms3dFusedPlanes& planes);

#endif
