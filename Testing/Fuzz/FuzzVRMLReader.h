// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What libFuzzer, and the test that replays its corpus, let the VRML97 reader read.
 */
#ifndef FuzzVRMLReader_h
#define FuzzVRMLReader_h

#include <cstddef>
#include <filesystem>

/**
 * A folder, made and removed with the object, with the scene input.wrl, and library.wrl beside it for
 * Inline and EXTERNPROTO; the reader opens no other file.
 */
class lms3dFuzzFolder
{
public:
  explicit lms3dFuzzFolder(const std::filesystem::path& folder);
  ~lms3dFuzzFolder();
  lms3dFuzzFolder(const lms3dFuzzFolder&) = delete;
  void operator=(const lms3dFuzzFolder&) = delete;

  /// Reads the bytes as a scene; aborts where a triangle has no such points, or a point is not
  /// finite.
  void Read(const char* data, std::size_t size) const;

private:
  std::filesystem::path Folder;
};

#endif
