// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Opens and parses the files of a scene, each file once.
 */
#ifndef lms3dVRMLDocumentCache_h
#define lms3dVRMLDocumentCache_h

#include "Grammar/lms3dVRMLNode.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>

class lms3dVRMLContext;

/**
 * Opens files below SceneRoot only. Owns the documents: pointers to them and to their prototypes
 * are valid as long as the cache exists. The context must outlive it.
 */
class lms3dVRMLDocumentCache
{
public:
  explicit lms3dVRMLDocumentCache(lms3dVRMLContext& context)
    : Context(context)
  {
  }

  /// Parses the file of the scene. Call first, since it sets the root folder. Returns null, and
  /// adds a message, if the file cannot be read.
  const lms3dVRMLDocument* ReadScene(const std::string& fileName);

  /// Returns the document of the first URL of an Inline that can be read. Relative URLs refer to
  /// `from`, the document that contains them. Returns null, and adds a message about `inlineNode`,
  /// if no URL can be read.
  const lms3dVRMLDocument* FindInline(
    const lms3dVRMLStrings& urls, const lms3dVRMLDocument& from, const lms3dVRMLNode& inlineNode);

  /// Returns a PROTO itself, or the PROTO that an EXTERNPROTO refers to. Returns null, and adds a
  /// message, if there is none.
  const lms3dVRMLPrototype* FindBody(const lms3dVRMLPrototype& prototype);

private:
  struct File
  {
    std::unique_ptr<lms3dVRMLDocument> Document;
    /// Why there is no document, as a phrase to follow the file's name.
    std::string Problem;
  };

  /// `shownName` is the file's name in messages.
  const File& Read(const std::filesystem::path& path, const std::string& shownName);
  /// Returns Refused if the URL must not be opened.
  const File& Open(const std::string& url, const lms3dVRMLDocument& from);
  const lms3dVRMLPrototype* FindExternal(const lms3dVRMLPrototype& prototype);
  void CompareInterfaces(const lms3dVRMLPrototype& prototype, const lms3dVRMLPrototype& body);
  bool IsBelowRoot(const std::filesystem::path& path) const;

  lms3dVRMLContext& Context;
  std::filesystem::path Root;
  /// Keyed by real path, links resolved.
  std::map<std::filesystem::path, File> Files;
  std::unordered_map<const lms3dVRMLPrototype*, const lms3dVRMLPrototype*> Bodies;
  File Refused;
};

#endif
