// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dSceneCatalogue.h"

#include "Common/lms3dLog.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <system_error>

namespace
{
// The bounds of SceneName and SceneNames in LMS3DScanner.idl.
constexpr std::size_t MaximumNameLength = 128;
constexpr std::size_t MaximumScenes = 4096;

bool IsScene(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return extension == ".wrl" || extension == ".vrml" || extension == ".wrz";
}

// Printable ASCII, which every ORB transmits unchanged in any character set.
bool IsPlain(const std::string& name)
{
  return std::all_of(name.begin(), name.end(),
    [](unsigned char character) { return character >= 0x20 && character < 0x7f; });
}
} // namespace

lms3dSceneCatalogue::lms3dSceneCatalogue(const std::filesystem::path& folder)
{
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    std::error_code unreadable;
    if (IsScene(entry->path()) && entry->is_regular_file(unreadable))
    {
      this->Add(entry->path());
    }
  }
  if (error)
  {
    throw std::runtime_error(
      "the folder of scenes \"" + folder.string() + "\" cannot be read: " + error.message());
  }
  if (this->Files.empty())
  {
    throw std::runtime_error("the folder of scenes \"" + folder.string() +
      "\" has no file that ends in .wrl, .vrml or .wrz");
  }
}

void lms3dSceneCatalogue::Add(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  if (name.size() > MaximumNameLength || !IsPlain(name))
  {
    lms3dLog(
      "a scene is left out: its name is longer than 128 characters or not plain ASCII: " + name);
  }
  else if (this->Files.size() == MaximumScenes)
  {
    lms3dLog("a scene is left out: there are more than 4,096: " + name);
  }
  else
  {
    this->Files[name] = std::filesystem::absolute(file);
  }
}

std::vector<std::string> lms3dSceneCatalogue::GetNames() const
{
  std::vector<std::string> names;
  names.reserve(this->Files.size());
  for (const auto& file : this->Files)
  {
    names.push_back(file.first);
  }
  return names;
}

const std::filesystem::path* lms3dSceneCatalogue::Find(const std::string& name) const
{
  const auto file = this->Files.find(name);
  return file == this->Files.end() ? nullptr : &file->second;
}
