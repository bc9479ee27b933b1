// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The bounded map as an output of vtkLMS3DSurfaceReconstructionFilter.
 */
#ifndef lms3dBoundedOutput_h
#define lms3dBoundedOutput_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"

class lms3dMapScan;
class vtkPolyData;

/// Fills the arrays that the public header of vtkLMS3DSurfaceReconstructionFilter lists for a
/// bounded map. Points are in world coordinates, metres. `map` must be empty.
void lms3dFillBoundedOutput(
  const lms3dMapScan& scan, const lms3dBoundedMap& bounded, vtkPolyData* map);

#endif
