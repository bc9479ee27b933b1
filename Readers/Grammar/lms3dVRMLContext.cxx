// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLContext.h"

#include "Grammar/lms3dVRMLNode.h"

#include <algorithm>

namespace
{
constexpr std::int64_t NodesPerReport = 4096;
constexpr std::uint64_t WorkAllowance = 1'000'000;
constexpr std::size_t BytesPerTriangle = 3 * sizeof(std::int32_t);
} // namespace

bool lms3dVRMLContext::Report(double fraction)
{
  this->Fraction = std::max(this->Fraction, fraction);
  this->IsAborted = this->IsAborted || !this->Progress(this->Fraction);
  return !this->IsAborted;
}

bool lms3dVRMLContext::CountParsedNode(const std::string& file, std::size_t line)
{
  ++this->ParsedNodes;
  return this->CheckLimit(this->ParsedNodes <= this->Options.MaximumNumberOfNodes,
           "MaximumNumberOfNodes", "--scene-nodes", file, line) &&
    this->CountMemory(sizeof(lms3dVRMLNode), file, line) && !this->IsAborted;
}

bool lms3dVRMLContext::CountNode(const std::string& file, std::size_t line)
{
  if (++this->Nodes % NodesPerReport == 0)
  {
    this->Report(this->Fraction);
  }
  this->IsFull = this->IsFull ||
    !this->CheckLimit(this->Nodes <= this->Options.MaximumNumberOfNodes, "MaximumNumberOfNodes",
      "--scene-nodes", file, line);
  return !this->IsFull && !this->IsAborted;
}

bool lms3dVRMLContext::CountWork(std::size_t count, const std::string& file, std::size_t line)
{
  const std::uint64_t limit =
    static_cast<std::uint64_t>(this->Options.MaximumNumberOfTriangles) + WorkAllowance;
  this->IsFull = this->IsFull ||
    !this->CheckLimit(
      count <= limit - this->Work, "MaximumNumberOfTriangles", "--scene-triangles", file, line) ||
    !this->HasMemory(count * BytesPerTriangle, file, line);
  this->Work += this->IsFull ? 0 : count;
  return !this->IsFull;
}

bool lms3dVRMLContext::CountTriangles(std::size_t count, const std::string& file, std::size_t line)
{
  this->IsFull = this->IsFull ||
    !this->CheckLimit(
      static_cast<std::int64_t>(count) <= this->Options.MaximumNumberOfTriangles - this->Triangles,
      "MaximumNumberOfTriangles", "--scene-triangles", file, line);
  this->Triangles += this->IsFull ? 0 : static_cast<std::int64_t>(count);
  return !this->IsFull;
}

bool lms3dVRMLContext::CountMemory(std::size_t bytes, const std::string& file, std::size_t line)
{
  this->IsFull = this->IsFull || !this->HasMemory(bytes, file, line);
  this->Memory += this->IsFull ? 0 : bytes;
  return !this->IsFull;
}

bool lms3dVRMLContext::HasMemory(std::size_t bytes, const std::string& file, std::size_t line)
{
  return this->CheckLimit(
    bytes <= this->GetMemoryLeft(), "MaximumMemory", "--scene-memory, in MB", file, line);
}

bool lms3dVRMLContext::CheckLimit(
  bool isWithin, const char* limit, const char* option, const std::string& file, std::size_t line)
{
  if (!isWithin && this->ReportedLimits.insert(limit).second)
  {
    // Before the first node is visited, the memory is for the text, and no shape can be made.
    const bool isText = limit == std::string("MaximumMemory") && this->Nodes == 0;
    this->Messages.AddError(file, line,
      std::string(
        isText ? "no shape is read: the text alone" : "the rest of the scene is not read: it") +
        " is larger than " + limit +
        " allows. Raise this limit if you trust the scene (on the command line " + option + ")");
  }
  return isWithin;
}
