// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The paper's endless loop: scans one after the other, at a set rate.
 */
#ifndef lms3dScanLoop_h
#define lms3dScanLoop_h

#include "lms3dScanPipeline.h"
#include "lms3dSettingsBoard.h"
#include "lms3dSnapshotStore.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

class lms3dScanLoop
{
public:
  /// `rate` in scans a second, 0: as fast as it goes. Board and store must outlive the loop.
  lms3dScanLoop(
    const lms3dSettingsBoard& board, lms3dSnapshotStore& store, double rate, int threads);
  ~lms3dScanLoop();
  lms3dScanLoop(const lms3dScanLoop&) = delete;
  void operator=(const lms3dScanLoop&) = delete;

  void Start();
  /// Ends the scan that is being made, too.
  void Stop();

  /// Nanoseconds since 1970; see ScanHeader.
  std::uint64_t GetIncarnation() const { return this->Incarnation; }
  /// See Status.
  std::uint64_t GetNumberOfLateScans() const { return this->LateScans; }
  /// Why the newest settings give no scan; empty where they do.
  std::string GetProblem() const;

private:
  using Clock = std::chrono::steady_clock;

  void Run();
  void MakeScan();
  void SetProblem(const std::string& problem);
  /// When the next scan is due, after one that was due at `due`.
  Clock::time_point GetNext(Clock::time_point due);
  /// False where the loop is to end.
  bool SleepUntil(Clock::time_point time);

  const lms3dSettingsBoard& Board;
  lms3dSnapshotStore& Store;
  const Clock::duration Period;
  const std::uint64_t Incarnation;
  lms3dScanPipeline Pipeline;
  std::uint64_t Number = 0;
  std::atomic<std::uint64_t> LateScans{ 0 };
  mutable std::mutex Mutex;
  std::condition_variable Woken;
  bool Stopped = false;
  std::string Problem;
  std::thread Thread;
};

#endif
