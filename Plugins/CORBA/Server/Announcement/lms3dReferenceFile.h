// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The file that tells clients of the same machine where the server is.
 */
#ifndef lms3dReferenceFile_h
#define lms3dReferenceFile_h

#include <string>

/// Is there while this lives, and never half written.
class lms3dReferenceFile
{
public:
  /// Throws std::runtime_error where it cannot be written, or something is there that is no file.
  lms3dReferenceFile(const std::string& name, const std::string& reference);
  /// Removes it, unless another server has written its own meanwhile.
  ~lms3dReferenceFile();
  lms3dReferenceFile(const lms3dReferenceFile&) = delete;
  void operator=(const lms3dReferenceFile&) = delete;

private:
  const std::string Name;
  const std::string Reference;
};

#endif
