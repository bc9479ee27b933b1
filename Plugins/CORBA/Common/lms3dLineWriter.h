// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Writes lines without waiting for their reader.
 */
#ifndef lms3dLineWriter_h
#define lms3dLineWriter_h

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

/**
 * Writes lines to a file descriptor in a thread of its own. A pipe or a terminal whose reader stops
 * reading blocks this thread alone. All methods may be called from any thread.
 */
class lms3dLineWriter
{
public:
  /// Bytes of lines that wait. Further lines are left out and counted.
  static constexpr std::size_t MaximumBytes = 262144;

  /// Makes the line that replaces `count` lines that were left out.
  using Describe = std::function<std::string(std::size_t count)>;

  /// Starts the thread, which blocks all signals. `file` must stay open until the thread ends.
  lms3dLineWriter(int file, Describe describe);
  /// Does not wait for the thread, because it may never end. Call Flush() before.
  ~lms3dLineWriter();
  lms3dLineWriter(const lms3dLineWriter&) = delete;
  void operator=(const lms3dLineWriter&) = delete;

  /// Passes a line, without its end, to the thread, and returns at once.
  void Write(const std::string& line);

  /// Waits until all lines are written. Returns false if that takes longer than `timeout`.
  bool Flush(std::chrono::milliseconds timeout);

private:
  class Queue;
  /// The thread shares its ownership.
  const std::shared_ptr<Queue> Lines;
};

#endif
