// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The classes of characters of VRML97 (ISO/IEC 14772-1, annex A).
 */
#ifndef lms3dVRMLCharacters_h
#define lms3dVRMLCharacters_h

/// Whitespace includes the comma. Control characters count as whitespace too, since no token may
/// contain them.
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

/// Returns whether the character ends a number or the name of a node.
inline bool lms3dEndsName(char c)
{
  return lms3dIsBlank(c) || c == '[' || c == ']' || c == '{' || c == '}' || c == '"' || c == '#';
}

/// Returns whether the character ends any other word.
inline bool lms3dEndsWord(char c)
{
  return lms3dEndsName(c) || c == '.';
}

/// Includes the first letters of "nan" and "inf".
inline bool lms3dMayBeginNumber(char c)
{
  return lms3dIsDigit(c) || c == '-' || c == '+' || c == '.' || c == 'n' || c == 'N' || c == 'i' ||
    c == 'I';
}

#endif
