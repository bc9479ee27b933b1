// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The field data of a scan.
 */
#ifndef lms3dScanFieldData_h
#define lms3dScanFieldData_h

#include "Device/lms3dScanGeometry.h"

class vtkPolyData;

/// Adds the arrays AlphaAngles, BetaAngles (degrees) and SensorToWorld, which the header of
/// vtkLMS3DScanFilter documents.
void lms3dAddFieldData(const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkPolyData* scan);

#endif
