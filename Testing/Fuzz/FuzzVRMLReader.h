// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads any bytes with the VRML97 reader, for libFuzzer and for the test of its corpus.
 */
#ifndef FuzzVRMLReader_h
#define FuzzVRMLReader_h

#include <cstddef>
#include <filesystem>

/**
 * A folder that the object creates and removes. It contains the scene input.wrl, and library.wrl
 * for Inline and EXTERNPROTO. The reader opens no other file.
 */
class lms3dFuzzFolder
{
public:
  explicit lms3dFuzzFolder(const std::filesystem::path& folder);
  ~lms3dFuzzFolder();
  lms3dFuzzFolder(const lms3dFuzzFolder&) = delete;
  void operator=(const lms3dFuzzFolder&) = delete;

  /// Reads the bytes as a scene. Aborts the process if an index of a triangle is out of range or a
  /// point is not finite.
  void Read(const char* data, std::size_t size) const;

private:
  std::filesystem::path Folder;
};

#endif
