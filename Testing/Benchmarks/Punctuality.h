// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How well a server keeps its rate.
 */
#ifndef Punctuality_h
#define Punctuality_h

#include "LMS3DScanner.hh"

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

/// Sees every scan of a server while it lives.
class Punctuality
{
public:
  explicit Punctuality(LMS3D::LaserScanner_ptr scanner);
  ~Punctuality();
  Punctuality(const Punctuality&) = delete;
  void operator=(const Punctuality&) = delete;

  /// Ends the watching.
  void Stop();

  double GetScansPerSecond() const;

  /**
   * Milliseconds that each scan began after its time, which is a period after that of the one before;
   * anew from the scan's begin where it was a whole period late, as the server does it. The most
   * punctual scan counts as punctual.
   */
  std::vector<double> GetLateness(double rate) const;

private:
  struct Begin
  {
    std::uint64_t Number;
    /// Seconds.
    double Time;
  };

  void Watch();

  const LMS3D::LaserScanner_var Scanner;
  std::vector<Begin> Begins;
  std::atomic<bool> Stopped{ false };
  std::thread Watcher;
};

#endif
