// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads whole files, plain or packed by gzip.
 */
#ifndef lms3dFile_h
#define lms3dFile_h

#include <cstdint>
#include <string>

/// Returns whether the file exists and is a regular file: no folder, pipe or device. Links are
/// followed.
bool lms3dIsRegularFile(const std::string& fileName);

/// Returns whether the file can be opened and begins with the signature of gzip.
bool lms3dIsPackedFile(const std::string& fileName);

/// Returns the first `count` bytes of the unpacked file. Returns fewer bytes if the file is shorter
/// or damaged, and none if it cannot be opened.
std::string lms3dReadBeginning(const std::string& fileName, std::size_t count);

struct lms3dFileContents
{
  /// The unpacked bytes, as many as could be read.
  std::string Text;
  /// Why bytes are missing, as a phrase to follow the file's name: "cannot be opened". Empty if
  /// Text is complete.
  std::string Problem;
};

/// Reads a regular file and unpacks it if gzip has packed it. Returns the first `maximumBytes`
/// bytes of a longer one.
lms3dFileContents lms3dReadFile(const std::string& fileName, std::int64_t maximumBytes);

#endif
