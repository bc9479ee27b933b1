// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A server's scan and map as VTK data.
 */
#ifndef lms3dRemoteData_h
#define lms3dRemoteData_h

#include "lms3dRemoteScan.h"

class vtkPolyData;

/// Output 0 of vtkLMS3DScanFilter without `CellId`, which does not travel. Ranges are those that came,
/// floats; points lie at them. Further field data, one uint64 each: `ScanNumber`, `Incarnation`,
/// `Generation`, `StartTime` and `EndTime` of the header; and the name of the `Scene`.
void lms3dFillScan(const lms3dRemoteScan& remote, vtkPolyData* scan);

/// The local map's triangles, with `Range` (float64, metres) at its points and this further field data.
void lms3dFillMap(const lms3dRemoteScan& remote, vtkPolyData* map);

#endif
