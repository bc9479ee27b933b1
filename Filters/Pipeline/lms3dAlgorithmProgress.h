// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Connects lms3dProgress to the progress and the abort of a VTK filter.
 */
#ifndef lms3dAlgorithmProgress_h
#define lms3dAlgorithmProgress_h

#include "Pipeline/lms3dProgress.h"

class vtkAlgorithm;

/// Returns a progress that updates the algorithm's progress, where 0 to 1 become `first` to `last`,
/// and that stops the work if the algorithm is aborted. The algorithm must outlive the result. VTK
/// allows calls only on the thread that runs the algorithm.
lms3dProgress lms3dReportTo(vtkAlgorithm* algorithm, double first, double last);

#endif
