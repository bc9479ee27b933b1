// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What all parts of one reading share: its options, messages, limits and progress.
 */
#ifndef lms3dVRMLContext_h
#define lms3dVRMLContext_h

#include "lms3dMessages.h"
#include "lms3dVRMLReader.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

/// No node, prototype, instance or Inline is deeper inside others: what the parser, which goes down
/// by recursion, can do on a stack of 1 MB.
constexpr int lms3dVRMLMaximumDepth = 1000;

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

  /// Tells the share of a file that is done, 0 to 1; of several files, the first tells most. False
  /// where the user wants no more.
  bool Report(double share);

  ///@{
  /// Count what a file has at a line; false where it is to be left out and no more is wanted: beyond
  /// the options' limit, with a message, and after the user's abort.
  bool CountParsedNode(const std::string& file, std::size_t line);
  bool CountNode(const std::string& file, std::size_t line);
  bool CountTriangles(std::size_t count, const std::string& file, std::size_t line);
  ///@}

  /// The same, before a mesh is made, of how many triangles it may have: so that much which turns out
  /// to have no surface ends too. The options' limit holds for all meshes together, and a little more
  /// for what has less than it may.
  bool CountWork(std::size_t count, const std::string& file, std::size_t line);

  /// How many bytes the files that are still to come may have.
  std::int64_t GetBytesLeft() const { return this->Options.MaximumFileSize - this->Bytes; }
  void CountBytes(std::size_t count) { this->Bytes += static_cast<std::int64_t>(count); }

private:
  bool Hold(bool isWithin, const std::string& limit, const std::string& file, std::size_t line);

  const lms3dProgressFunction& Progress;
  double Share = 0.0;
  std::int64_t ParsedNodes = 0;
  std::int64_t Nodes = 0;
  std::int64_t Triangles = 0;
  std::uint64_t Work = 0;
  std::int64_t Bytes = 0;
  bool IsAborted = false;
  /// Whether the shapes are as many as they may be.
  bool IsFull = false;
  std::set<std::string> LimitsTold;
};

#endif
