// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Copies the outputs of the filters to a scan that the server keeps.
 */
#ifndef lms3dFilterOutputs_h
#define lms3dFilterOutputs_h

#include "Scanning/lms3dSnapshotStore.h"

class vtkImageData;
class vtkPolyData;

/// Fills in the ranges, the statuses if the device of the snapshot has them, and the header's
/// numbers and checksums of a scan without a map.
void lms3dTakeScan(vtkPolyData* scan, vtkImageData* image, lms3dSnapshot& snapshot);

/// Fills in the map, and the header's numbers and checksum of it.
void lms3dTakeMap(vtkPolyData* map, lms3dSnapshot& snapshot);

#endif
