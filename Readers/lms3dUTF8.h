// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes text of bytes.
 */
#ifndef lms3dUTF8_h
#define lms3dUTF8_h

#include <cstddef>
#include <string>
#include <string_view>

/// Valid UTF-8, as VRML97 files should be. Bytes that are not are taken for Latin-1, as older
/// programs write it.
std::string lms3dToUTF8(std::string_view bytes);

/// The first bytes, and not a part of a character.
std::string_view lms3dCutUTF8(std::string_view text, std::size_t mostBytes);

#endif
