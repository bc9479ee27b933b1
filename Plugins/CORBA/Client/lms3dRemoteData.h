// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts a server's scan and local map to VTK data.
 */
#ifndef lms3dRemoteData_h
#define lms3dRemoteData_h

#include "Client/lms3dRemoteScan.h"

class vtkPolyData;

/**
 * Fills an empty vtkPolyData with the points, arrays and field data of output 0 of
 * vtkLMS3DScanFilter (metres, world coordinates), without `CellId`, which the server does not send.
 * Ranges have the precision of floats, and the points lie at these ranges. The field data have the
 * properties of the platform, and `Status` if the device has computeStatus. Adds to the field data,
 * one uint64 each, `ScanNumber`, `Incarnation`, `Generation`, `StartTime` and `EndTime` of the
 * header, and the string `Scene`. The scan must have passed the checks of lms3dRemoteCheck.h.
 */
void lms3dFillScan(const lms3dRemoteScan& remote, vtkPolyData* scan);

/// Fills an empty vtkPolyData with the triangles of the local map (metres, world coordinates), with
/// `Range` (float64, metres) at its points and the same additional field data. The same
/// precondition holds.
void lms3dFillMap(const lms3dRemoteScan& remote, vtkPolyData* map);

#endif
