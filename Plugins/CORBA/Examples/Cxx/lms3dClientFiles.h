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

/// Throws std::runtime_error if one of the files cannot become a VTK file, or two names mean the
/// same file. Call it before the work begins.
void lms3dCheckFiles(const std::vector<std::string>& files);

/// Writes a temporary file and renames it, so that `file` is complete or unchanged. Removes the
/// temporary file if a signal ends the program, such as SIGINT by Ctrl-C. Not thread-safe. Throws
/// std::runtime_error if it fails.
void lms3dWriteFile(vtkPolyData* data, const std::string& file);

#endif
