// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads whole files, also those that gzip has packed.
 */
#ifndef lms3dFile_h
#define lms3dFile_h

#include <cstdint>
#include <string>

/// Whether there is such a file that is no folder, pipe or device.
bool lms3dIsRegularFile(const std::string& fileName);

/// The first bytes after unpacking; fewer, or none, where the file has no more or cannot be read.
std::string lms3dReadBeginning(const std::string& fileName, std::size_t count);

struct lms3dFileContents
{
  std::string Text;
  /// Why not all of it was read; empty where it was.
  std::string Problem;
};

/// A regular file after unpacking, and of a longer one so many bytes.
lms3dFileContents lms3dReadFile(const std::string& fileName, std::int64_t mostBytes);

#endif
