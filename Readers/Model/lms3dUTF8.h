// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts the bytes of a file to valid UTF-8.
 */
#ifndef lms3dUTF8_h
#define lms3dUTF8_h

#include <cstddef>
#include <string>
#include <string_view>

/// Returns the bytes as valid UTF-8, the encoding of VRML97. Bytes that are not valid UTF-8 are
/// interpreted as Latin-1, which older programs write.
std::string lms3dToUTF8(std::string_view bytes);

/// Returns the first `maximumBytes` bytes, or a few less so that no character is cut.
std::string_view lms3dCutUTF8(std::string_view text, std::size_t maximumBytes);

#endif
