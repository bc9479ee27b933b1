// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads one number in any form that VRML97 allows.
 */
#ifndef lms3dVRMLNumber_h
#define lms3dVRMLNumber_h

#include "Grammar/lms3dVRMLCharacters.h"

#include <cstdint>

struct lms3dVRMLNumber
{
  /// Points behind the last character of the number; null if there is no number.
  const char* End = nullptr;
  double Real = 0.0;
  /// Whether the number has neither fraction nor exponent and fits into Integer.
  bool IsInteger = false;
  std::int32_t Integer = 0;
};

/// Reads a number of any form, including 0x1F, 1e400 (infinite), nan, and 1.#IND as Windows prints
/// it. Requires begin < end.
lms3dVRMLNumber lms3dReadAnyNumber(const char* begin, const char* end);

/// Returns the same as lms3dReadAnyNumber(), faster for short integers. Most numbers in large files
/// are short integers.
inline lms3dVRMLNumber lms3dReadNumber(const char* begin, const char* end)
{
  constexpr int maximumDigits = 9;
  const bool isNegative = *begin == '-';
  const char* const digits = begin + (isNegative ? 1 : 0);
  const char* p = digits;
  std::int32_t value = 0;
  for (; p < end && lms3dIsDigit(*p) && p - digits < maximumDigits; ++p)
  {
    value = 10 * value + (*p - '0');
  }
  if (p == digits || (p < end && !lms3dEndsName(*p)))
  {
    return lms3dReadAnyNumber(begin, end);
  }
  value = isNegative ? -value : value;
  return { p, static_cast<double>(value), true, value };
}

#endif
