// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ends the work of VTK algorithms when the server ends.
 */
#ifndef lms3dAbort_h
#define lms3dAbort_h

#include <functional>

class vtkAlgorithm;

/// True where the server is to end; from any thread.
using lms3dStopTest = std::function<bool()>;

/// Has the algorithm ask, each time it tells its progress, and abort where it is so.
void lms3dAbortIf(vtkAlgorithm* algorithm, const lms3dStopTest& isStopped);

#endif
