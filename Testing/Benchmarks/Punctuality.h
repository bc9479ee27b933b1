// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures how well a server keeps its rate.
 */
#ifndef Punctuality_h
#define Punctuality_h

#include "LMS3DScanner.hh"

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

/// Watches every scan of a server in a thread of its own, as long as this object lives.
class Punctuality
{
public:
  explicit Punctuality(LMS3D::LaserScanner_ptr scanner);
  ~Punctuality();
  Punctuality(const Punctuality&) = delete;
  void operator=(const Punctuality&) = delete;

  /// Ends the thread. Call it before the getters.
  void Stop();

  double GetScansPerSecond() const;

  /**
   * Milliseconds between the due time of each scan and its begin. A scan is due one period after
   * the due time of the scan before. As in the server, a scan that begins a whole period late is a
   * new start. The earliest scan, relative to its due time, counts as punctual. `rate` is in scans
   * per second.
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
