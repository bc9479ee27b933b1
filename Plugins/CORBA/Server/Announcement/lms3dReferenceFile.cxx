// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Announcement/lms3dReferenceFile.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <system_error>

namespace
{
bool WriteNew(const std::string& name, const std::string& text)
{
  std::FILE* const file = std::fopen(name.c_str(), "wx");
  const bool isWritten = file && std::fputs(text.c_str(), file) >= 0;
  return file && std::fclose(file) == 0 && isWritten;
}

// Renaming would replace devices and pipes too.
void RequireFile(const std::string& name)
{
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(name, problem);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    throw std::runtime_error(
      "cannot write the reference to \"" + name + "\": it is not a regular file");
  }
}
} // namespace

// Writes a temporary file first, whose name differs from that of other servers.
lms3dReferenceFile::lms3dReferenceFile(const std::string& name, const std::string& reference)
  : Name(name)
  , Reference(reference)
{
  RequireFile(name);
  const std::string temporary = name + "." + std::to_string(std::random_device()());
  if (!WriteNew(temporary, reference + '\n') || std::rename(temporary.c_str(), name.c_str()) != 0)
  {
    std::remove(temporary.c_str());
    throw std::runtime_error("cannot write the reference to \"" + name + "\"");
  }
}

lms3dReferenceFile::~lms3dReferenceFile()
{
  std::string now;
  std::getline(std::ifstream(this->Name), now);
  if (now == this->Reference)
  {
    std::remove(this->Name.c_str());
  }
}
