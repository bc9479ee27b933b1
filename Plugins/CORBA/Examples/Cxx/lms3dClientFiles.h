// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Files that lms3d-client writes.
 */
#ifndef lms3dClientFiles_h
#define lms3dClientFiles_h

#include <string>
#include <vector>

class vtkPolyData;

/// Throws std::runtime_error where one of these cannot become a VTK file: before the work begins.
void lms3dCheckFiles(const std::vector<std::string>& files);

/// Writes beside the file and renames then, so that it is there as a whole, or as it was before.
/// Throws std::runtime_error where that fails.
void lms3dWriteFile(vtkPolyData* data, const std::string& file);

#endif
