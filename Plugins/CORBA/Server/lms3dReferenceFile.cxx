// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dReferenceFile.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

lms3dReferenceFile::lms3dReferenceFile(const std::string& name, const std::string& reference)
  : Name(name)
  , Reference(reference)
{
  const std::string temporary = name + ".tmp";
  std::ofstream stream(temporary, std::ios::trunc);
  stream << reference << '\n';
  stream.close();
  if (!stream || std::rename(temporary.c_str(), name.c_str()) != 0)
  {
    std::remove(temporary.c_str());
    throw std::runtime_error("the file \"" + name + "\" cannot be written");
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
