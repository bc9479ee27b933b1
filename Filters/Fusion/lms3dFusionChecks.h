// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Validates a scan and its local map before they join a fused map.
 */
#ifndef lms3dFusionChecks_h
#define lms3dFusionChecks_h

class vtkPolyData;

/// Throws std::runtime_error, with a text for the user. `maximumError` is that of the fused map,
/// metres.
void lms3dCheckFusionInput(vtkPolyData* map, vtkPolyData* scan, double maximumError);

#endif
