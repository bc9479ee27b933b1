// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scenes that clients may choose, by name.
 */
#ifndef lms3dSceneCatalogue_h
#define lms3dSceneCatalogue_h

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/**
 * The VRML files that are in a folder, not below it, when the catalogue is made. A scene's name is its
 * file's. A client's text is only ever looked up here, so no path can be made of it.
 */
class lms3dSceneCatalogue
{
public:
  /// Throws std::runtime_error where the folder cannot be read or has no scene.
  explicit lms3dSceneCatalogue(const std::filesystem::path& folder);

  /// In alphabetical order, at least one.
  std::vector<std::string> GetNames() const;

  /// Null where there is no such scene.
  const std::filesystem::path* Find(const std::string& name) const;

private:
  void Add(const std::filesystem::path& file);

  std::map<std::string, std::filesystem::path> Files;
};

#endif
