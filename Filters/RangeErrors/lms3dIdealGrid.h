// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the returns of a scan to the grid of their ranges.
 */
#ifndef lms3dIdealGrid_h
#define lms3dIdealGrid_h

#include "Device/lms3dScanInput.h"

/// Fills the grid (turn by turn, metres) with the ranges of the returns, and NaN for all other
/// beams. Throws std::runtime_error, with a text for the user, if a return is bad. Uses the threads
/// of the calling TBB arena.
void lms3dFillGrid(const lms3dScanInput& scan, const lms3dScanGeometry& geometry, double* grid);

#endif
