// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for SIGTERM or SIGINT.
 */
#ifndef lms3dStopSignal_h
#define lms3dStopSignal_h

#include <string>

/// One in a process. Made before all else, so that no early signal ends the process halfway.
class lms3dStopSignal
{
public:
  /// Throws std::runtime_error where the system refuses.
  lms3dStopSignal();
  lms3dStopSignal(const lms3dStopSignal&) = delete;
  void operator=(const lms3dStopSignal&) = delete;

  /// Returns the signal's name when it has come.
  std::string Wait() const;
};

#endif
