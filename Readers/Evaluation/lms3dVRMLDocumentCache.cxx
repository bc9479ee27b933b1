// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/lms3dVRMLDocumentCache.h"

#include "Files/lms3dFile.h"
#include "Files/lms3dVRMLHeader.h"
#include "Files/lms3dVRMLUrl.h"
#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLParser.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace
{
namespace fs = std::filesystem;

// Joins the problems of all URLs that were tried in one line.
void Append(std::string& problems, const std::string& url, const std::string& problem)
{
  problems += (problems.empty() ? "\"" : "; \"") + url + "\" " + problem;
}
} // namespace

const lms3dVRMLDocument* lms3dVRMLDocumentCache::ReadScene(const std::string& fileName)
{
  std::error_code error;
  const fs::path path = fs::absolute(fileName, error);
  const std::string& root = this->Context.Options.SceneRoot;
  this->Root = fs::canonical(root.empty() ? path.parent_path() : fs::path(root), error);
  if (error && !root.empty())
  {
    this->Context.Messages.AddError(fileName, 0, "SceneRoot \"" + root + "\" is not a folder");
  }
  const File& file = this->Read(path, fileName);
  if (!file.Document)
  {
    this->Context.Messages.AddError(fileName, 0, file.Problem);
  }
  return file.Document.get();
}

// Caches files that cannot be read, too.
const lms3dVRMLDocumentCache::File& lms3dVRMLDocumentCache::Read(
  const fs::path& path, const std::string& shownName)
{
  std::error_code error;
  const fs::path realPath = fs::canonical(path, error);
  const auto [found, isNew] = this->Files.try_emplace(error ? path : realPath);
  File& file = found->second;
  if (!isNew)
  {
    return file;
  }

  const lms3dFileContents contents = lms3dReadFile(path.string(), this->Context.GetBytesLeft());
  this->Context.CountBytes(contents.Text.size());
  file.Problem = contents.Problem;
  if (contents.Text.empty())
  {
    file.Problem = contents.Problem.empty() ? "is empty" : contents.Problem;
    return file;
  }
  const std::string other = lms3dExplainBeginning(contents.Text.substr(0, lms3dVRMLHeaderLength));
  if (!other.empty())
  {
    file.Problem = other;
    return file;
  }
  if (!contents.Problem.empty())
  {
    this->Context.Messages.AddError(shownName, 0, contents.Problem);
  }
  file.Document = std::make_unique<lms3dVRMLDocument>();
  file.Document->FileName = shownName;
  file.Document->Folder = path.parent_path().string();
  lms3dVRMLParser(contents.Text, *file.Document, this->Context).Parse();
  return file;
}

bool lms3dVRMLDocumentCache::IsBelowRoot(const fs::path& path) const
{
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return !error && !this->Root.empty() &&
    std::mismatch(this->Root.begin(), this->Root.end(), real.begin(), real.end()).first ==
    this->Root.end();
}

const lms3dVRMLDocumentCache::File& lms3dVRMLDocumentCache::Open(
  const std::string& url, const lms3dVRMLDocument& from)
{
  const lms3dVRMLUrl parts(url);
  const fs::path path = (fs::path(from.Folder) / parts.Path).lexically_normal();
  this->Refused.Problem = !parts.IsFile          ? "is not a local file"
    : parts.Path.empty()                         ? "has no file name"
    : parts.Path.find('\0') != std::string::npos ? "is not a file name"
    : !this->IsBelowRoot(path) ? "is not below SceneRoot (on the command line --scene-root)"
                               : "";
  return this->Refused.Problem.empty()
    ? this->Read(
        path, (fs::path(from.FileName).parent_path() / parts.Path).lexically_normal().string())
    : this->Refused;
}

const lms3dVRMLDocument* lms3dVRMLDocumentCache::FindInline(
  const lms3dVRMLStrings& urls, const lms3dVRMLDocument& from, const lms3dVRMLNode& inlineNode)
{
  std::string problems;
  for (const std::string& url : urls)
  {
    const File& file = this->Open(url, from);
    if (file.Document)
    {
      return file.Document.get();
    }
    Append(problems, url, file.Problem);
  }
  if (!urls.empty())
  {
    this->Context.Messages.AddError(
      inlineNode.Document->FileName, inlineNode.Line, "an Inline is lost: " + problems);
  }
  return nullptr;
}

// An EXTERNPROTO can refer to an EXTERNPROTO of another file. The depth limit ends cycles.
const lms3dVRMLPrototype* lms3dVRMLDocumentCache::FindBody(const lms3dVRMLPrototype& prototype)
{
  const lms3dVRMLPrototype* found = &prototype;
  for (int depth = 0; found && found->IsExternal; ++depth)
  {
    if (depth == this->Context.Options.MaximumInlineDepth)
    {
      this->Context.Messages.AddError(prototype.Document->FileName, prototype.Line,
        "EXTERNPROTO " + std::string(prototype.Name) +
          " leads through more files than MaximumInlineDepth allows");
      return nullptr;
    }
    const auto known = this->Bodies.find(found);
    found = known != this->Bodies.end() ? known->second
                                        : this->Bodies[found] = this->FindExternal(*found);
  }
  return found;
}

// Warns about fields that the PROTO does not have: values of the instances for them have no effect.
void lms3dVRMLDocumentCache::CompareInterfaces(
  const lms3dVRMLPrototype& prototype, const lms3dVRMLPrototype& body)
{
  for (const lms3dVRMLField& field : prototype.Interface)
  {
    if (!lms3dFindField(body.Interface, field.Name))
    {
      this->Context.Messages.AddWarning(prototype.Document->FileName, field.Line,
        "EXTERNPROTO " + std::string(prototype.Name) + " declares " + std::string(field.Name) +
          ", which its PROTO in " + body.Document->FileName + " does not have");
    }
  }
}

// A URL without a name after # refers to the first PROTO of the file.
const lms3dVRMLPrototype* lms3dVRMLDocumentCache::FindExternal(const lms3dVRMLPrototype& prototype)
{
  std::string problems;
  for (const std::string& url : prototype.Urls)
  {
    const File& file = this->Open(url, *prototype.Document);
    if (!file.Document)
    {
      Append(problems, url, file.Problem);
      continue;
    }
    const std::string name = lms3dVRMLUrl(url).Fragment;
    const auto found = file.Document->PrototypesByName.find(name);
    const lms3dVRMLPrototype* body = name.empty()      ? file.Document->FirstPrototype
      : found == file.Document->PrototypesByName.end() ? nullptr
                                                       : found->second;
    if (body)
    {
      this->CompareInterfaces(prototype, *body);
      return body;
    }
    Append(problems, url, "has no such PROTO");
  }
  this->Context.Messages.AddError(prototype.Document->FileName, prototype.Line,
    "EXTERNPROTO " + std::string(prototype.Name) +
      " is lost: " + (problems.empty() ? "it has no url" : problems));
  return nullptr;
}
