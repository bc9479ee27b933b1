// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The files that a scene is made of, each parsed once.
 */
#ifndef lms3dVRMLLibrary_h
#define lms3dVRMLLibrary_h

#include "lms3dVRMLNode.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>

class lms3dVRMLContext;

class lms3dVRMLLibrary
{
public:
  explicit lms3dVRMLLibrary(lms3dVRMLContext& context)
    : Context(context)
  {
  }

  /// The file that is the scene; null, and a message, where it cannot be read.
  const lms3dVRMLDocument* ReadScene(const std::string& fileName);

  /// The first of an Inline's urls that can be read, from where they are written; null, and a
  /// message that names this place, where there is none.
  const lms3dVRMLDocument* FindInline(
    const lms3dVRMLStrings& urls, const lms3dVRMLDocument& from, const lms3dVRMLNode& place);

  /// The prototype itself, or that which an EXTERNPROTO stands for; null, and a message, where there
  /// is none.
  const lms3dVRMLPrototype* FindBody(const lms3dVRMLPrototype& prototype);

private:
  struct File
  {
    std::unique_ptr<lms3dVRMLDocument> Document;
    /// Why there is no document.
    std::string Problem;
  };

  const File& Read(const std::filesystem::path& path, const std::string& shownName);
  const File& Open(const std::string& url, const lms3dVRMLDocument& from);
  const lms3dVRMLPrototype* FindExternal(const lms3dVRMLPrototype& prototype);
  void CompareInterfaces(const lms3dVRMLPrototype& prototype, const lms3dVRMLPrototype& body);
  bool IsBelowRoot(const std::filesystem::path& path) const;

  lms3dVRMLContext& Context;
  std::filesystem::path Root;
  /// By their real paths.
  std::map<std::filesystem::path, File> Files;
  std::unordered_map<const lms3dVRMLPrototype*, const lms3dVRMLPrototype*> Bodies;
  File Refused;
};

#endif
