// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dOptionSources.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{
using Words = lms3dOptionSetting::Words;

bool BeginsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

std::string Trim(const std::string& text)
{
  constexpr const char* Blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

void RequireCount(const Words& values, std::size_t count)
{
  if (values.size() != count)
  {
    throw std::invalid_argument(
      "it takes " + std::to_string(count) + " values, not " + std::to_string(values.size()));
  }
}

// One value is all that is there, for a file's name may have blanks.
Words Split(const std::string& values, std::size_t count)
{
  if (count == 1)
  {
    return { values };
  }
  std::istringstream stream(values);
  Words words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::string DescribePlace(const std::string& file, int number, const std::string& line)
{
  return file + ":" + std::to_string(number) + ": \"" + line + "\"";
}

lms3dOptionSetting ParseLine(const std::string& line, lms3dOptionCount getCount)
{
  const std::size_t equals = line.find('=');
  lms3dOptionSetting setting;
  setting.Name = Trim(line.substr(0, equals));
  if (setting.Name == "config")
  {
    throw std::invalid_argument("a configuration file names no other");
  }
  const std::size_t count = getCount(setting.Name);
  const std::string values = equals == std::string::npos ? "" : Trim(line.substr(equals + 1));
  setting.Values = values.empty() ? Words() : Split(values, count);
  RequireCount(setting.Values, count);
  return setting;
}

lms3dOptionSetting ReadLine(
  const std::string& line, const std::string& origin, lms3dOptionCount getCount)
{
  try
  {
    lms3dOptionSetting setting = ParseLine(line, getCount);
    setting.Origin = origin;
    return setting;
  }
  catch (const std::invalid_argument& problem)
  {
    throw std::invalid_argument(origin + ": " + problem.what());
  }
}

Words ReadLines(const std::string& file)
{
  std::ifstream stream(file);
  Words lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  // A folder can be opened, and fails when it is read.
  if (!stream.is_open() || stream.bad())
  {
    throw std::invalid_argument("the configuration file \"" + file + "\" cannot be read");
  }
  // What some editors write before all text.
  constexpr const char* ByteOrderMark = "\xEF\xBB\xBF";
  if (!lines.empty() && BeginsWith(lines[0], ByteOrderMark))
  {
    lines[0].erase(0, std::char_traits<char>::length(ByteOrderMark));
  }
  return lines;
}

// The values after place `i`, which moves on to the last of them.
Words TakeValues(const std::vector<std::string>& arguments, std::size_t& i, std::size_t count)
{
  Words values;
  while (values.size() < count && i + 1 < arguments.size())
  {
    values.push_back(arguments[++i]);
  }
  RequireCount(values, count);
  return values;
}
} // namespace

lms3dCommandLine lms3dReadCommandLine(
  const std::vector<std::string>& arguments, lms3dOptionCount getCount)
{
  lms3dCommandLine line;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& origin = arguments[i];
    try
    {
      if (BeginsWith(origin, "-ORB"))
      {
        line.ORBArguments.insert(
          line.ORBArguments.end(), { origin, TakeValues(arguments, i, 1)[0] });
      }
      else
      {
        const std::string name = BeginsWith(origin, "--") ? origin.substr(2) : std::string();
        line.Settings.push_back({ origin, name, TakeValues(arguments, i, getCount(name)) });
      }
    }
    catch (const std::invalid_argument& problem)
    {
      throw std::invalid_argument(origin + ": " + problem.what());
    }
  }
  return line;
}

std::vector<lms3dOptionSetting> lms3dReadOptionFile(
  const std::string& file, lms3dOptionCount getCount)
{
  std::vector<lms3dOptionSetting> settings;
  int number = 0;
  for (const std::string& whole : ReadLines(file))
  {
    ++number;
    const std::string line = Trim(whole);
    if (!line.empty() && line[0] != '#')
    {
      settings.push_back(ReadLine(line, DescribePlace(file, number, line), getCount));
    }
  }
  return settings;
}
