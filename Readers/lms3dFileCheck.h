// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Checks that a file is a VRML97 file before it is parsed.
 */
#ifndef lms3dFileCheck_h
#define lms3dFileCheck_h

#include <string>

/// An error that ends the execution of a reader. Thrown and caught within this module.
struct lms3dReadFailure
{
  /// One of vtkErrorCode.
  unsigned long ErrorCode;
  /// For the user.
  std::string Text;
};

/// Throws lms3dReadFailure if the file cannot be opened or does not begin as a VRML97 file, and if
/// gzip has packed it although `isPackedAllowed` is false. `fileName` can be null.
void lms3dCheckFile(const char* fileName, bool isPackedAllowed);

#endif
