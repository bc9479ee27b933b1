// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes a plane of returns that were grouped anew.
 */
#ifndef lms3dRegroupedPlane_h
#define lms3dRegroupedPlane_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dBeamTable.h"
#include "Fusion/Scans/lms3dReturnGroups.h"
#include "Fusion/Scans/lms3dWorldBox.h"

#include <vector>

/// Returns the number of a new, weak plane for the returns of a group, without surface and returns.
/// If one of the old planes is nearly the same, the new one has its tiles at nearly the same
/// places, so that it does not have fewer triangles only because of other tiles.
int lms3dMakeRegroupedPlane(
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes, lms3dFusedPlanes& planes);

/// Gives a plane its surface and the returns of its group. It has surface between neighbouring
/// beams that meet it, and where triangles of the old planes are within the bound of it. Each scan
/// of a return must have a table, from which its neighbouring beams follow. Returns the box by
/// which the box of the plane must grow. Threads may call this for different planes at the same
/// time.
lms3dWorldBox lms3dFillRegroupedPlane(int number, const std::vector<lms3dMappedReturn>& returns,
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes,
  const lms3dTablesOfScans& tables, lms3dFusedPlanes& planes);

#endif
