// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Recognises a VRML97 file by its first line.
 */
#ifndef lms3dVRMLHeader_h
#define lms3dVRMLHeader_h

#include <cstddef>
#include <string>

/// The number of bytes that lms3dExplainBeginning() needs.
constexpr std::size_t lms3dVRMLHeaderLength = 64;

/// Returns an empty string if a file that begins with these (unpacked) bytes is a VRML97 file in
/// text form. Otherwise returns what the file is, as a phrase to follow its name: "is a VRML 1.0
/// file, ...".
std::string lms3dExplainBeginning(const std::string& beginning);

#endif
