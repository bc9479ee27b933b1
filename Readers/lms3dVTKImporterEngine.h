// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads a VRML 2.0 file with vtkVRMLImporter. No other file uses this class.
 */
#ifndef lms3dVTKImporterEngine_h
#define lms3dVTKImporterEngine_h

#include "Model/lms3dScene.h"

#include <functional>
#include <string>

/// `progress` receives the fraction done, 0 to 1. If it returns false, the reading stops and the
/// shapes so far are returned. A malformed file can crash the process.
lms3dScene lms3dReadWithVTKImporter(
  const std::string& fileName, const std::function<bool(double)>& progress);

#endif
