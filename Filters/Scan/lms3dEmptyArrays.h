// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gives the empty scans of all other processes the arrays of the first process's scan.
 */
#ifndef lms3dEmptyArrays_h
#define lms3dEmptyArrays_h

#include "Scan/lms3dProcesses.h"

class vtkDataSetAttributes;

/// In all processes but the first, adds an empty array for each array of the first process's
/// `data`: with the same name, type, components and role (scalars, normals). Without these arrays,
/// a filter that appends the pieces could drop them. Collective.
void lms3dAddEmptyArrays(const lms3dProcesses& processes, vtkDataSetAttributes* data);

#endif
