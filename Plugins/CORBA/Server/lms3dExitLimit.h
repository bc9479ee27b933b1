// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Limits how long the process takes to end.
 */
#ifndef lms3dExitLimit_h
#define lms3dExitLimit_h

#include <condition_variable>
#include <mutex>
#include <thread>

/// Exits at most five seconds after Begin(), unless this object is destroyed before. So a client, a
/// listener or a naming service that does not answer cannot keep the server alive.
class lms3dExitLimit
{
public:
  /// Starts a thread, because threads may have run out when the end begins.
  lms3dExitLimit();
  ~lms3dExitLimit();
  lms3dExitLimit(const lms3dExitLimit&) = delete;
  void operator=(const lms3dExitLimit&) = delete;

  /// Begins the five seconds, unless they have begun already. Any thread.
  void Begin(int exitCode);

private:
  void Run();

  std::mutex Mutex;
  std::condition_variable Changed;
  bool Begun = false;
  bool Ended = false;
  int ExitCode = 0;
  std::thread Thread;
};

#endif
