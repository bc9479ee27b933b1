// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What characters are in VRML97 (ISO/IEC 14772-1, annex A).
 */
#ifndef lms3dVRMLCharacters_h
#define lms3dVRMLCharacters_h

/// The comma is one; control characters are in no token.
inline bool lms3dIsBlank(char c)
{
  return static_cast<unsigned char>(c) <= 0x20 || c == ',' || c == 0x7f;
}

inline bool lms3dIsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

inline bool lms3dIsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Whether a number or a name cannot go on with it.
inline bool lms3dEndsName(char c)
{
  return lms3dIsBlank(c) || c == '[' || c == ']' || c == '{' || c == '}' || c == '"' || c == '#';
}

inline bool lms3dEndsWord(char c)
{
  return lms3dEndsName(c) || c == '.';
}

inline bool lms3dMayBeginNumber(char c)
{
  return lms3dIsDigit(c) || c == '-' || c == '+' || c == '.' || c == 'n' || c == 'N' || c == 'i' ||
    c == 'I';
}

#endif
