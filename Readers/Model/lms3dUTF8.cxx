// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/lms3dUTF8.h"

#include <algorithm>

namespace
{
bool Continues(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// The number of bytes of the first character; 0 if the text does not begin with a valid one.
std::size_t GetLength(std::string_view text)
{
  const unsigned char first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xC2 && first < 0xE0       ? 2
    : first >= 0xE0 && first < 0xF0       ? 3
    : first >= 0xF0 && first < 0xF5       ? 4
                                          : 0;
  if (length == 0 || text.size() < length ||
    !std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), Continues))
  {
    return 0;
  }
  // Overlong forms, surrogates, and code points above the last one.
  const unsigned char second = static_cast<unsigned char>(length > 1 ? text[1] : 0);
  const bool isForbidden = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
    (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return isForbidden ? 0 : length;
}
} // namespace

std::string lms3dToUTF8(std::string_view bytes)
{
  std::string text;
  while (!bytes.empty())
  {
    const std::size_t length = GetLength(bytes);
    if (length > 0)
    {
      text += bytes.substr(0, length);
    }
    else
    {
      const unsigned char byte = static_cast<unsigned char>(bytes[0]);
      text += static_cast<char>(0xC0 | (byte >> 6));
      text += static_cast<char>(0x80 | (byte & 0x3F));
    }
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return text;
}

std::string_view lms3dCutUTF8(std::string_view text, std::size_t maximumBytes)
{
  std::size_t end = std::min(text.size(), maximumBytes);
  while (end > 0 && end < text.size() && Continues(text[end]))
  {
    --end;
  }
  return text.substr(0, end);
}
