// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Connects the progress of VTK-free code with the progress and abort of a VTK filter.
 */
#ifndef lms3dAlgorithmProgress_h
#define lms3dAlgorithmProgress_h

#include "Pipeline/lms3dProgress.h"

class vtkAlgorithm;

/// Reports the share done, within `first` to `last` of the filter's whole work, and asks for abort.
lms3dProgress lms3dReportTo(vtkAlgorithm* algorithm, double first, double last);

#endif
