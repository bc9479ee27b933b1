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

/// Adds the wanted ones among the point arrays Time, SensorPosition and SensorOrientation, as
/// vtkLMS3DScanFilter documents them, to a scan with the array BeamId. Uses the threads of the calling TBB
/// arena.
void lms3dAddPoseArrays(
  const lms3dMovingBeams& beams, const lms3dExtraArrays& wanted, vtkPolyData* scan);

/// Adds the field data TurnToWorld.
void lms3dAddTurnPoses(const lms3dMovingBeams& beams, vtkPolyData* scan);

#endif
