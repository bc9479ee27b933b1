// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A file with the reference of the server's object, for clients of the same machine.
 */
#ifndef lms3dReferenceFile_h
#define lms3dReferenceFile_h

#include <string>

/// The file exists as long as this object. It appears by renaming, so clients never read half a
/// reference.
class lms3dReferenceFile
{
public:
  /// Throws std::runtime_error if the file cannot be written, or if `name` is not a regular file.
  lms3dReferenceFile(const std::string& name, const std::string& reference);
  /// Removes the file, unless another server has replaced it.
  ~lms3dReferenceFile();
  lms3dReferenceFile(const lms3dReferenceFile&) = delete;
  void operator=(const lms3dReferenceFile&) = delete;

private:
  const std::string Name;
  const std::string Reference;
};

#endif
