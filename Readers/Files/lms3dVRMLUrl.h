// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The parts of a URL in a VRML97 file.
 */
#ifndef lms3dVRMLUrl_h
#define lms3dVRMLUrl_h

#include <string>

struct lms3dVRMLUrl
{
  /// Splits a URL or a plain path. Removes the scheme "file:", decodes escapes such as %20 and
  /// replaces each \ by /.
  explicit lms3dVRMLUrl(const std::string& text);

  /// False for http: and every other scheme except file:.
  bool IsFile = true;
  /// Empty if the URL names another host.
  std::string Path;
  /// The part after #, without it; for EXTERNPROTO the name of a prototype.
  std::string Fragment;
};

#endif
