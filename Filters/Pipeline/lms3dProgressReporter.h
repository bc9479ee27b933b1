// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Limits how often parallel work reports its progress.
 */
#ifndef lms3dProgressReporter_h
#define lms3dProgressReporter_h

#include "Pipeline/lms3dProgress.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

/**
 * Forwards progress to a function from the thread that made the reporter, after each tenth of the
 * work or each 50 ms. (A report costs more than a row of a scan.) All threads may call Report. The
 * function receives values that never fall. The reporter keeps a reference to the function.
 */
class lms3dProgressReporter
{
public:
  explicit lms3dProgressReporter(const lms3dProgress& progress)
    : Progress(progress)
  {
  }

  /// Takes the share of the work that is done, 0 to 1. Returns false if the work has to stop.
  bool Report(double done)
  {
    if (std::this_thread::get_id() == this->Thread && this->IsDue(done) && !this->IsStopped())
    {
      this->Reported = std::max(this->Reported, done);
      this->Time = std::chrono::steady_clock::now();
      this->Stopped = !this->Progress(this->Reported);
    }
    return !this->IsStopped();
  }

  bool IsStopped() const { return this->Stopped; }

private:
  bool IsDue(double done) const
  {
    constexpr double Step = 0.1;
    constexpr std::chrono::milliseconds Interval(50);
    return done >= this->Reported + Step ||
      std::chrono::steady_clock::now() >= this->Time + Interval;
  }

  const lms3dProgress& Progress;
  const std::thread::id Thread = std::this_thread::get_id();
  std::atomic<bool> Stopped{ false };

  /// The last report. Only the thread above uses these.
  double Reported = 0.0;
  std::chrono::steady_clock::time_point Time = std::chrono::steady_clock::now();
};

#endif
