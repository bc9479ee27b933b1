// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The field data of a scan.
 */
#ifndef lms3dScanFieldData_h
#define lms3dScanFieldData_h

#include "Device/lms3dScanGeometry.h"

#include <array>
#include <vector>

class vtkFieldData;
class vtkPolyData;

/// The axes of the grid of beams, degrees, and the platform. The axes are empty if a scan was
/// stopped.
struct lms3dGridAngles
{
  std::vector<double> Alpha;
  std::vector<double> Beta;
  lms3dPlatform Platform;
};

/// Returns AlphaAngles, BetaAngles and the platform. The axes are empty if one of them is missing,
/// empty or not finite, if there are more than 2^31 - 1 beams, or if lms3dGetPlatform() would
/// throw.
lms3dGridAngles lms3dGetGridAngles(vtkFieldData* data);

/// Returns the platform that the arrays Mounting, AxisOffset and TurnRate describe, each with its
/// default if it is missing. Throws std::runtime_error, with a text for the user, if one is bad.
lms3dPlatform lms3dGetPlatform(vtkFieldData* data);

/// Returns the matrix from the sensor frame to the world, row-major.
std::array<double, 16> lms3dToMatrix(const lms3dPose& pose);

/// Adds the arrays AlphaAngles, BetaAngles (degrees) and SensorToWorld, and the arrays of the
/// platform that differ from their defaults, which the header of vtkLMS3DScanFilter documents.
void lms3dAddFieldData(const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkPolyData* scan);

#endif
