// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The grid of a scan whose returns are in one or more of several processes.
 *
 * All functions are collective: all processes must call them in the same order, on the thread that
 * runs the filter. A null controller stands for this process alone.
 */
#ifndef lms3dSharedGrid_h
#define lms3dSharedGrid_h

#include "Device/lms3dScanFieldData.h"

#include <cstddef>

class vtkMultiProcessController;

/// Returns the angles and the platform of the first process that has angles, in all processes.
lms3dGridAngles lms3dShareAngles(
  const lms3dGridAngles& mine, vtkMultiProcessController* controller);

/// Gives all processes the ranges of all. The grid has `beams` values, NaN without a return.
void lms3dMergeGrids(vtkMultiProcessController* controller, std::size_t beams, double* grid);

#endif
