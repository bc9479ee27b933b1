// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the grid of reported ranges back to the returns of a scan.
 */
#ifndef lms3dReportedScan_h
#define lms3dReportedScan_h

#include "Device/lms3dScanInput.h"
#include "Pipeline/lms3dMemoryPool.h"

class vtkPolyData;

/**
 * Fills an empty `output` with the returns of `input` at the ranges of a grid. `scan` has the
 * arrays of `input`. The points and the array Range change, and all other arrays are shared.
 * Returns whose range is NaN in the grid are removed. New arrays take their memory from `pool`.
 * Uses the threads of the calling TBB arena.
 */
void lms3dFillReportedScan(const lms3dScanInput& scan, const lms3dScanGeometry& geometry,
  const double* grid, lms3dMemoryPool& pool, vtkPolyData* input, vtkPolyData* output);

#endif
