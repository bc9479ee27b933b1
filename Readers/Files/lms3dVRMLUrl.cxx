// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/lms3dVRMLUrl.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace
{
// Returns an empty string for a plain path. A single letter is a drive of Windows, not a scheme.
std::string GetScheme(const std::string& text)
{
  const std::size_t end = text.find(':');
  if (end == std::string::npos || end < 2 ||
    !std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end),
      [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; }))
  {
    return "";
  }
  std::string scheme = text.substr(0, end);
  std::transform(scheme.begin(), scheme.end(), scheme.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return scheme;
}

std::string Decode(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    unsigned char code = 0;
    const char* digits = text.data() + i + 1;
    const bool isCode = text[i] == '%' && i + 2 < text.size() &&
      std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    result += isCode ? static_cast<char>(code) : text[i] == '\\' ? '/' : text[i];
    i += isCode ? 2 : 0;
  }
  return result;
}

// Accepts "///a/b", "//localhost/a/b", "/a/b" and "a/b". Returns an empty string for another host.
std::string RemoveHost(const std::string& text)
{
  if (text.compare(0, 2, "//") != 0)
  {
    return text;
  }
  const std::size_t path = std::min(text.find('/', 2), text.size());
  const std::string host = text.substr(2, path - 2);
  return host.empty() || host == "localhost" ? text.substr(path) : "";
}
} // namespace

lms3dVRMLUrl::lms3dVRMLUrl(const std::string& text)
{
  const std::size_t hash = text.rfind('#');
  const std::string scheme = GetScheme(text);
  this->IsFile = scheme.empty() || scheme == "file";
  if (hash != std::string::npos)
  {
    this->Fragment = Decode(text.substr(hash + 1));
  }
  const std::string address = text.substr(0, hash);
  this->Path = Decode(scheme == "file" ? RemoveHost(address.substr(5)) : address);
}
