// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The parts of a url.
 */
#ifndef lms3dVRMLUrl_h
#define lms3dVRMLUrl_h

#include <string>

struct lms3dVRMLUrl
{
  /// Takes "file:" off and resolves %20 and its like; \ counts as /.
  explicit lms3dVRMLUrl(const std::string& text);

  /// False for http: and all other schemes but file:.
  bool IsFile = true;
  std::string Path;
  /// What comes after #.
  std::string Fragment;
};

#endif
