// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The state that all parts of one reading share: options, messages, limits and progress.
 */
#ifndef lms3dVRMLContext_h
#define lms3dVRMLContext_h

#include "Grammar/lms3dVRMLOptions.h"
#include "Model/lms3dMessages.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

/// The maximum nesting of nodes, prototypes, instances and Inlines. The parser is recursive: this
/// depth fits on a stack of 1 MB.
constexpr int lms3dVRMLMaximumDepth = 1000;

/// Keeps references to both constructor arguments, which must outlive it.
class lms3dVRMLContext
{
public:
  lms3dVRMLContext(const lms3dVRMLOptions& options, const lms3dProgressFunction& progress)
    : Options(options)
    , Progress(progress)
  {
  }

  const lms3dVRMLOptions& Options;
  lms3dMessages Messages;

  /// Reports the fraction of a file that is done, 0 to 1. The reported progress never decreases:
  /// while an Inline is parsed, it mostly stands still. Returns false after the user's abort.
  bool Report(double fraction);

  ///@{
  /// Count an item at a line of a file. Return false if the item must be skipped and the reading
  /// must end: if a limit of the options is exceeded (the first time with a message), or after the
  /// user's abort.
  bool CountParsedNode(const std::string& file, std::size_t line);
  bool CountNode(const std::string& file, std::size_t line);
  bool CountTriangles(std::size_t count, const std::string& file, std::size_t line);
  bool CountMemory(std::size_t bytes, const std::string& file, std::size_t line);
  ///@}

  /// Counts the triangles that a geometry node could have, before its mesh is made. Without this, a
  /// scene of many degenerate faces could cost unlimited time, because it has no triangles to
  /// count. The limit is MaximumNumberOfTriangles plus one million. The triangles must also fit
  /// into the memory that is left, which does not change. Returns as the functions above.
  bool CountWork(std::size_t count, const std::string& file, std::size_t line);

  ///@{
  /// Return how many bytes of files may still be read, and how many bytes may still be made of
  /// them.
  std::int64_t GetBytesLeft() const { return this->Options.MaximumFileSize - this->Bytes; }
  std::uint64_t GetMemoryLeft() const
  {
    return static_cast<std::uint64_t>(this->Options.MaximumMemory) - this->Memory;
  }
  ///@}
  void CountBytes(std::size_t count) { this->Bytes += static_cast<std::int64_t>(count); }

private:
  /// Returns `isWithin`. Reports the first time that a limit is exceeded. `option` is its name on
  /// the command line.
  bool CheckLimit(bool isWithin, const char* limit, const char* option, const std::string& file,
    std::size_t line);
  /// Returns whether so much can still be made.
  bool HasMemory(std::size_t bytes, const std::string& file, std::size_t line);

  const lms3dProgressFunction& Progress;
  double Fraction = 0.0;
  std::int64_t ParsedNodes = 0;
  std::int64_t Nodes = 0;
  std::int64_t Triangles = 0;
  std::uint64_t Work = 0;
  std::int64_t Bytes = 0;
  std::uint64_t Memory = 0;
  bool IsAborted = false;
  /// Whether no more shapes are collected, because a limit is exceeded.
  bool IsFull = false;
  std::set<std::string> ReportedLimits;
};

#endif
