// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientProgram.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

Outcome RunClient(
  const Client& client, const std::string& reference, const std::vector<std::string>& values)
{
  std::vector<std::string> words = client.Program;
  words.push_back(reference);
  words.insert(words.end(), client.Command.begin(), client.Command.end());
  words.insert(words.end(), values.begin(), values.end());
  std::string command;
  for (const std::string& word : words)
  {
    command.append("'").append(word).append("' ");
  }
  FILE* const pipe = popen((command + "2>&1").c_str(), "r");
  Outcome outcome;
  std::array<char, 65536> buffer;
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe))
  {
    outcome.Text.append(buffer.data(), size);
  }
  outcome.Code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

std::vector<float> ReadTable(const Outcome& outcome)
{
  std::vector<float> numbers;
  const char* text = outcome.Text.c_str();
  for (char* end = nullptr; *text; text = end + 1)
  {
    numbers.push_back(std::strtof(text, &end));
    const char separator = numbers.size() % 3 == 0 ? '\n' : '\t';
    if (end == text || *end != separator)
    {
      ADD_FAILURE() << "no table of three columns from here on: "
                    << std::string(text).substr(0, 300);
      return {};
    }
  }
  EXPECT_EQ(outcome.Code, 0);
  return numbers;
}

Map ReadMap(const std::filesystem::path& path)
{
  Map map;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::array<double, 3> n{};
    EXPECT_EQ(std::sscanf(line.c_str(), "%*c %lf %lf %lf", &n[0], &n[1], &n[2]), 3) << line;
    for (const double number : n)
    {
      line[0] == 'v' ? map.Points.push_back(number)
                     : map.Triangles.push_back(static_cast<std::uint32_t>(number) - 1);
    }
  }
  return map;
}

TemporaryFile::TemporaryFile(const std::string& name)
  : Path(std::filesystem::path(testing::TempDir()) / (std::to_string(getpid()) + '-' + name))
{
}

TemporaryFile::~TemporaryFile()
{
  std::filesystem::remove(this->Path);
}
