// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dConfigurationFile.h"

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace
{
std::vector<std::string> ReadLines(const std::string& file)
{
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(lms3dTrim(line));
  }
  // A folder can be opened, but reading it fails.
  if (!stream.is_open() || stream.bad())
  {
    throw std::invalid_argument("the configuration file \"" + file + "\" cannot be read");
  }
  // Some editors write it before the text.
  const std::string byteOrderMark = "\xEF\xBB\xBF";
  if (!lines.empty() && lines[0].rfind(byteOrderMark, 0) == 0)
  {
    lines[0] = lms3dTrim(lines[0].substr(byteOrderMark.size()));
  }
  return lines;
}
} // namespace

std::string lms3dTrim(const std::string& text)
{
  constexpr const char* Blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

void lms3dReadConfigurationFile(
  const std::string& file, const std::function<void(const std::string& line)>& parse)
{
  int number = 0;
  for (const std::string& line : ReadLines(file))
  {
    ++number;
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    try
    {
      parse(line);
    }
    catch (const std::invalid_argument& problem)
    {
      std::ostringstream message;
      message << file << ':' << number << ": \"" << line << "\": " << problem.what();
      throw std::invalid_argument(message.str());
    }
  }
}
