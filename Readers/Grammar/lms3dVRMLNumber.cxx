// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLNumber.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>

namespace
{
// All 32 bits are allowed: 0xffffffff is -1.
lms3dVRMLNumber ReadHexadecimal(const char* digits, const char* end, bool isNegative)
{
  std::uint32_t value = 0;
  const std::from_chars_result read = std::from_chars(digits, end, value, 16);
  if (read.ec != std::errc())
  {
    return {};
  }
  const std::int32_t integer = static_cast<std::int32_t>(isNegative ? 0 - value : value);
  return { read.ptr, static_cast<double>(integer), true, integer };
}

// Returns the power of ten of the first digit that is not 0.
double GetMagnitude(std::string_view mantissa)
{
  const std::size_t first = mantissa.find_first_of("123456789");
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  return static_cast<double>(point) - static_cast<double>(first);
}

// std::from_chars does not say in which direction a number is out of range. An exponent with too
// many digits counts as the largest one.
double RoundOutOfRange(std::string_view text)
{
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const std::string_view exponent = text.substr(std::min(end + 1, text.size()));
  const bool isNegative = !exponent.empty() && exponent.front() == '-';
  const std::size_t sign = exponent.find_first_not_of("+-");
  std::int64_t power = 0;
  if (sign != std::string_view::npos &&
    std::from_chars(exponent.data() + sign, exponent.data() + exponent.size(), power).ec !=
      std::errc())
  {
    power = std::numeric_limits<std::int64_t>::max();
  }
  const double magnitude =
    GetMagnitude(text.substr(0, end)) + (isNegative ? -1.0 : 1.0) * static_cast<double>(power);
  return magnitude < 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
}

lms3dVRMLNumber ReadReal(const char* begin, const char* end)
{
  lms3dVRMLNumber number;
  const std::from_chars_result read = std::from_chars(begin, end, number.Real);
  if (read.ec == std::errc::invalid_argument)
  {
    return {};
  }
  if (read.ec == std::errc::result_out_of_range)
  {
    number.Real = RoundOutOfRange({ begin, static_cast<std::size_t>(read.ptr - begin) });
  }
  number.End = read.ptr;
  // Windows prints 1.#INF and -1.#IND.
  if (read.ptr < end && *read.ptr == '#' && read.ptr[-1] == '.')
  {
    number.Real = std::numeric_limits<double>::quiet_NaN();
    number.End = std::find_if(read.ptr + 1, end, lms3dEndsName);
  }
  return number;
}

void FindInteger(const char* begin, lms3dVRMLNumber& number)
{
  const std::from_chars_result read = std::from_chars(begin, number.End, number.Integer);
  number.IsInteger = read.ec == std::errc() && read.ptr == number.End;
}
} // namespace

lms3dVRMLNumber lms3dReadAnyNumber(const char* begin, const char* end)
{
  const bool isNegative = *begin == '-';
  const char* const unsignedBegin = begin + (isNegative || *begin == '+' ? 1 : 0);
  const std::string_view text(unsignedBegin, static_cast<std::size_t>(end - unsignedBegin));
  const bool isHexadecimal = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  lms3dVRMLNumber number = isHexadecimal ? ReadHexadecimal(unsignedBegin + 2, end, isNegative)
                                         : ReadReal(isNegative ? begin : unsignedBegin, end);
  if (number.End && number.End < end && !lms3dEndsName(*number.End))
  {
    return {};
  }
  if (number.End && !isHexadecimal)
  {
    FindInteger(isNegative ? begin : unsignedBegin, number);
  }
  return number;
}
