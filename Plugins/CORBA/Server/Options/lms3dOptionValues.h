// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An option of lms3d-server, and its values.
 */
#ifndef lms3dOptionValues_h
#define lms3dOptionValues_h

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

struct lms3dServerOptions;

/// The pointers refer to texts that are always valid.
struct lms3dOption
{
  const char* Name;
  /// Number of values. A flag has none.
  int Count;
  const char* Values;
  const char* Help;
  /// Throws std::invalid_argument.
  void (*Set)(lms3dServerOptions&, const std::vector<std::string>&);
};

/// Reads a number. Throws std::invalid_argument, with the limits, for other texts.
template <typename Number>
Number lms3dReadOption(const std::string& text, Number minimum, Number maximum)
{
  Number number{};
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  // NaN fails both comparisons.
  if (result.ec != std::errc() || result.ptr != end || !(number >= minimum && number <= maximum))
  {
    std::ostringstream message;
    message << '"' << text << "\" is not a " << (std::is_integral<Number>() ? "whole " : "")
            << "number from " << minimum << " to " << maximum;
    throw std::invalid_argument(message.str());
  }
  return number;
}

/// Reads three coordinates or angles, from -1e6 to 1e6. Throws std::invalid_argument.
inline std::array<double, 3> lms3dReadVector(const std::vector<std::string>& words)
{
  constexpr double Maximum = 1e6;
  return { lms3dReadOption(words.at(0), -Maximum, Maximum),
    lms3dReadOption(words.at(1), -Maximum, Maximum),
    lms3dReadOption(words.at(2), -Maximum, Maximum) };
}

#endif
