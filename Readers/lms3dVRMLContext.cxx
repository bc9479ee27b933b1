// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLContext.h"

#include <algorithm>

namespace
{
constexpr std::int64_t NodesOfReport = 4096;
constexpr std::uint64_t WorkOfAnyScene = 1'000'000;
} // namespace

bool lms3dVRMLContext::Report(double share)
{
  this->Share = std::max(this->Share, share);
  this->IsAborted = this->IsAborted || !this->Progress(this->Share);
  return !this->IsAborted;
}

bool lms3dVRMLContext::CountParsedNode(const std::string& file, std::size_t line)
{
  ++this->ParsedNodes;
  return this->Hold(this->ParsedNodes <= this->Options.MaximumNumberOfNodes, "MaximumNumberOfNodes",
           file, line) &&
    !this->IsAborted;
}

bool lms3dVRMLContext::CountNode(const std::string& file, std::size_t line)
{
  if (++this->Nodes % NodesOfReport == 0)
  {
    this->Report(this->Share);
  }
  this->IsFull = this->IsFull ||
    !this->Hold(
      this->Nodes <= this->Options.MaximumNumberOfNodes, "MaximumNumberOfNodes", file, line);
  return !this->IsFull && !this->IsAborted;
}

bool lms3dVRMLContext::CountWork(std::size_t count, const std::string& file, std::size_t line)
{
  const std::uint64_t most =
    static_cast<std::uint64_t>(this->Options.MaximumNumberOfTriangles) + WorkOfAnyScene;
  this->IsFull =
    this->IsFull || !this->Hold(count <= most - this->Work, "MaximumNumberOfTriangles", file, line);
  this->Work += this->IsFull ? 0 : count;
  return !this->IsFull;
}

bool lms3dVRMLContext::CountTriangles(std::size_t count, const std::string& file, std::size_t line)
{
  this->IsFull = this->IsFull ||
    !this->Hold(
      static_cast<std::int64_t>(count) <= this->Options.MaximumNumberOfTriangles - this->Triangles,
      "MaximumNumberOfTriangles", file, line);
  this->Triangles += this->IsFull ? 0 : static_cast<std::int64_t>(count);
  return !this->IsFull;
}

bool lms3dVRMLContext::Hold(
  bool isWithin, const std::string& limit, const std::string& file, std::size_t line)
{
  if (!isWithin && this->LimitsTold.insert(limit).second)
  {
    this->Messages.AddError(
      file, line, "the rest of the scene is not read: it is larger than " + limit + " allows");
  }
  return isWithin;
}
