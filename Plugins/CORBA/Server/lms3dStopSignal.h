// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for SIGTERM, SIGINT or SIGHUP. A terminal sends SIGHUP when it is closed.
 */
#ifndef lms3dStopSignal_h
#define lms3dStopSignal_h

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <csignal>

/// Receives the signals in a thread of its own, and blocks them in all threads that start later.
/// Create it before all other threads. If SIGHUP is ignored, as under nohup, it stays ignored.
class lms3dStopSignal
{
public:
  /// `onArrival` is called once, in the thread of this object, when the first signal arrives.
  explicit lms3dStopSignal(std::function<void()> onArrival);
  ~lms3dStopSignal();
  lms3dStopSignal(const lms3dStopSignal&) = delete;
  void operator=(const lms3dStopSignal&) = delete;

  /// True if a signal has arrived. Any thread.
  bool IsPending() const;

  /// Waits for a signal and returns its name. Any thread.
  std::string Wait() const;

private:
  void Run();

  sigset_t Signals;
  const std::function<void()> OnArrival;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  /// Empty before the first signal.
  std::string Name;
  bool Ended = false;
  std::thread Thread;
};

#endif
