// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dOptionValues.h"

#include <charconv>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace
{
template <typename Number>
Number GetWithin(const std::string& text, Number lowest, Number highest, const char* kind)
{
  Number number{};
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  // NaN is not within.
  if (result.ec != std::errc() || result.ptr != end || !(number >= lowest && number <= highest))
  {
    std::ostringstream message;
    message << '"' << text << "\" is not " << kind << " from " << lowest << " to " << highest;
    throw std::invalid_argument(message.str());
  }
  return number;
}
} // namespace

double lms3dGetNumber(const std::string& text, double lowest, double highest)
{
  return GetWithin(text, lowest, highest, "a number");
}

int lms3dGetCount(const std::string& text, int lowest, int highest)
{
  return GetWithin(text, lowest, highest, "a whole number");
}

std::array<double, 3> lms3dGetVector(const std::vector<std::string>& words)
{
  constexpr double Largest = 1e6;
  return { lms3dGetNumber(words.at(0), -Largest, Largest),
    lms3dGetNumber(words.at(1), -Largest, Largest),
    lms3dGetNumber(words.at(2), -Largest, Largest) };
}

bool lms3dGetChoice(const std::string& text, const std::string& first, const std::string& second)
{
  if (text != first && text != second)
  {
    throw std::invalid_argument("\"" + text + "\" is neither " + first + " nor " + second);
  }
  return text == second;
}
