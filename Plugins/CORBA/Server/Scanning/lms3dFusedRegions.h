// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the output of vtkLMS3DMapFusion to the regions of a state.
 */
#ifndef lms3dFusedRegions_h
#define lms3dFusedRegions_h

#include "Scanning/lms3dFusedMapState.h"

class vtkLMS3DMapFusion;
class vtkPolyData;

/// The regions that changed after a revision of the filter. Their points are relative to `origin`,
/// and their state is `number`.
lms3dFusedRegions lms3dTakeFusedChanges(
  vtkLMS3DMapFusion* fusion, int sinceRevision, const LMS3D::Vector3& origin, std::uint64_t number);

/// The area of all triangles, square metres.
double lms3dGetArea(vtkPolyData* map);

/// Puts `changes` in the place of the regions with the same ids, unless these have the same
/// triangles. Forgets the regions that were removed more than lms3dFusedMapState::Memory states
/// before the state `number`.
void lms3dReplaceFusedRegions(
  const lms3dFusedRegions& changes, std::uint64_t number, lms3dFusedRegions& regions);

#endif
