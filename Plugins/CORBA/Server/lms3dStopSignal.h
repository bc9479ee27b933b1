// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for SIGTERM, SIGINT or SIGHUP. A terminal sends SIGHUP when it is closed.
 */
#ifndef lms3dStopSignal_h
#define lms3dStopSignal_h

#include <string>

#include <csignal>

/// Blocks the signals in all threads that start later, so that they stay pending for Wait(). Create
/// it before all other threads. If SIGHUP is ignored, as under nohup, it stays ignored.
class lms3dStopSignal
{
public:
  lms3dStopSignal();
  lms3dStopSignal(const lms3dStopSignal&) = delete;
  void operator=(const lms3dStopSignal&) = delete;

  /// True if a signal has arrived. Any thread.
  bool IsPending() const;

  /// Waits for a signal and returns its name. One thread only.
  std::string Wait() const;

private:
  sigset_t Signals;
};

#endif
