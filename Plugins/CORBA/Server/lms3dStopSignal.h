// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for SIGTERM, SIGINT, or SIGHUP, which a terminal that is closed sends.
 */
#ifndef lms3dStopSignal_h
#define lms3dStopSignal_h

#include <string>

#include <csignal>

/// Takes the signals away from the threads that are made after it, so that they interrupt nobody and
/// wait for Wait(); to be made before all threads.
class lms3dStopSignal
{
public:
  lms3dStopSignal();
  lms3dStopSignal(const lms3dStopSignal&) = delete;
  void operator=(const lms3dStopSignal&) = delete;

  /// True from the moment on that a signal has come.
  bool HasCome() const;

  /// Returns the signal's name when it has come, or if it has already.
  std::string Wait() const;

private:
  sigset_t Signals;
};

#endif
