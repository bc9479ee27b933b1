// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads one number in any of VRML97's forms.
 */
#ifndef lms3dVRMLNumber_h
#define lms3dVRMLNumber_h

#include "lms3dVRMLCharacters.h"

#include <cstdint>

struct lms3dVRMLNumber
{
  /// Behind its last character; null where there is no number.
  const char* End = nullptr;
  double Real = 0.0;
  /// Whether it has neither fraction nor exponent and fits into Integer.
  bool IsInteger = false;
  std::int32_t Integer = 0;
};

/// Any number: also 0x1F, 1e400 (infinite), nan, and 1.#IND as Windows prints it.
lms3dVRMLNumber lms3dReadAnyNumber(const char* begin, const char* end);

/// The same, and fast where it is a short integer, as most numbers of large files are.
inline lms3dVRMLNumber lms3dReadNumber(const char* begin, const char* end)
{
  constexpr int mostDigits = 9;
  const bool isNegative = *begin == '-';
  const char* const digits = begin + (isNegative ? 1 : 0);
  const char* p = digits;
  std::int32_t value = 0;
  for (; p < end && lms3dIsDigit(*p) && p - digits < mostDigits; ++p)
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
