// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads a VRML 2.0 file with vtkVRMLImporter, the only place that knows this class.
 */
#ifndef lms3dVTKImporterEngine_h
#define lms3dVTKImporterEngine_h

#include "lms3dScene.h"

#include <functional>
#include <string>

/// `progress` is told the share done, 0 to 1, and returns false to stop with what was read so far.
lms3dScene lms3dReadWithVTKImporter(
  const std::string& fileName, const std::function<bool(double)>& progress);

#endif
