// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief When the beams of a scan left, and where the sensor was then.
 */
#ifndef lms3dPoseArrays_h
#define lms3dPoseArrays_h

#include "Scan/lms3dDeviceSettings.h"
#include "Scan/lms3dMovingBeams.h"

class vtkPolyData;

/// Adds the wanted ones among the point arrays Time, SensorPosition and SensorOrientation, and, if
/// `hasTurnPoses`, the field data TurnToWorld, as vtkLMS3DScanFilter documents them, to a scan with
/// the array BeamId. Uses the threads of the calling TBB arena.
void lms3dAddPoseArrays(const lms3dMovingBeams& beams, const lms3dExtraArrays& wanted,
  bool hasTurnPoses, vtkPolyData* scan);

#endif
