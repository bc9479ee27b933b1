// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan whose returns say what they have hit.
 */
#ifndef LabelledScan_h
#define LabelledScan_h

#include <vtkSmartPointer.h>

class vtkDataObject;
class vtkLMS3DScanFilter;

/// A scan with SurfaceAttributes, of 61 beams in each of 72 turns, from the origin.
vtkSmartPointer<vtkLMS3DScanFilter> MakeLabelledScan(vtkDataObject* scene);

#endif
