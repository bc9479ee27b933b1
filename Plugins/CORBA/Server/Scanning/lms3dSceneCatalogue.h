// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scenes that clients may select, by name.
 */
#ifndef lms3dSceneCatalogue_h
#define lms3dSceneCatalogue_h

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/**
 * The VRML files in a folder, without its subfolders, at the time of construction. A scene has the
 * name of its file. A client's text is only compared with these names, so no path can be made from
 * it. Immutable, so all methods may be called from any thread.
 */
class lms3dSceneCatalogue
{
public:
  /// Throws std::runtime_error if the folder cannot be read or has no scene.
  explicit lms3dSceneCatalogue(const std::filesystem::path& folder);

  /// At least one name, in alphabetical order.
  std::vector<std::string> GetNames() const;

  /// The absolute path of a scene's file, owned by the catalogue. Null if there is no such scene.
  const std::filesystem::path* Find(const std::string& name) const;

private:
  void Add(const std::filesystem::path& file);

  std::map<std::string, std::filesystem::path> Files;
};

#endif
