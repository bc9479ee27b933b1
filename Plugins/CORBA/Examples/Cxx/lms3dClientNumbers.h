// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers among the arguments of lms3d-client.
 */
#ifndef lms3dClientNumbers_h
#define lms3dClientNumbers_h

#include <charconv>
#include <stdexcept>
#include <string>
#include <system_error>

/// Reads a number. Throws std::invalid_argument, with `name` and `kind`, for other words: "1e999",
/// "12x", and "-1" for a count. The server checks the limits.
template <typename Number>
Number lms3dReadClientNumber(const std::string& name, const std::string& word, const char* kind)
{
  Number number{};
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end)
  {
    throw std::invalid_argument(name + ": \"" + word + "\" is not " + kind);
  }
  return number;
}

#endif
