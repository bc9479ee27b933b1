// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Limits the lines of the log that clients can cause.
 */
#ifndef lms3dLogLimit_h
#define lms3dLogLimit_h

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

/// Passes on the lines of one kind, at most 20 per second, and logs how many it left out. All
/// methods may be called from any thread.
class lms3dLogLimit
{
public:
  using Log = void (*)(const std::string& line);

  static constexpr int MaximumPerSecond = 20;

  /// `kind` begins the lines of this object itself. `log` is called from any thread.
  lms3dLogLimit(std::string kind, Log log);
  lms3dLogLimit(const lms3dLogLimit&) = delete;
  void operator=(const lms3dLogLimit&) = delete;

  void Write(const std::string& line);

  /// Logs how many lines were left out since the last such line, if any. The next line of a later
  /// second does so, too.
  void Report();

private:
  /// The mutex must be locked.
  void ReportLocked();

  const std::string Kind;
  const Log LogLine;
  std::mutex Mutex;
  std::chrono::steady_clock::time_point Begin;
  int LinesOfSecond = 0;
  std::size_t LeftOut = 0;
};

#endif
