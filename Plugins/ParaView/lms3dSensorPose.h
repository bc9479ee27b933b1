// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the sensor of a scan is, and how large its scene and its handle are.
 */

#ifndef lms3dSensorPose_h
#define lms3dSensorPose_h

#include <vtkBoundingBox.h>

class vtkSMProxy;
class vtkTransform;

/// The bounds of the input of a scan. Invalid without an input, and if the input has no data yet.
vtkBoundingBox lms3dGetSceneBounds(vtkSMProxy* scan);

/// The trajectory of a scan. Null for a sensor without this property, such as LMS3D Remote's.
vtkSMProxy* lms3dGetTrajectory(vtkSMProxy* sensor);

/// Half the width of the sensor's box, metres: large enough to be dragged in a hall, small enough
/// not to hide a room.
double lms3dGetHandleHalfWidth(vtkSMProxy* scan);

/// The pose in the properties Position and Rotation of a box widget.
void lms3dGetPoseOfBox(vtkSMProxy* box, vtkTransform* pose);

/// The pose in the field data of the last scan. Fails if there is no scan yet, and if a server
/// scans.
bool lms3dGetPoseOfScan(vtkSMProxy* scan, vtkTransform* pose);

#endif
