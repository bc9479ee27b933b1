// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The paper's endless loop: makes scan after scan, at a given rate, in a thread of its own.
 */
#ifndef lms3dScanLoop_h
#define lms3dScanLoop_h

#include "Scanning/lms3dFusedMapMaker.h"
#include "Scanning/lms3dScanPipeline.h"
#include "Scanning/lms3dSettingsBoard.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

/**
 * Reads the settings of each scan from a board and publishes the scan in a store. New settings
 * begin a scan at once, and abort one that takes long; the next scan is due one period after that
 * start. The getters may be called from any thread.
 */
class lms3dScanLoop
{
public:
  /// `rate` in scans per second; 0: without pauses. `threads` as NumberOfThreads of the filters.
  /// Board and store must outlive the loop.
  lms3dScanLoop(lms3dSettingsBoard& board, lms3dSnapshotStore& store, double rate, int threads);

  /// Adds each scan to a map of many scans before it is published. Call before Start(). The store
  /// must outlive the loop.
  void MakeFusedMap(const lms3dFusedMapOptions& options, lms3dFusedMapStore& store);
  ~lms3dScanLoop();
  lms3dScanLoop(const lms3dScanLoop&) = delete;
  void operator=(const lms3dScanLoop&) = delete;

  void Start();
  /// Aborts the current scan, ends waiting for new settings, and waits for the thread.
  void Stop();

  /// The start of the server, nanoseconds since 1970; see ScanHeader.
  std::uint64_t GetIncarnation() const { return this->Incarnation; }
  /// Scans that began at least one period late; see Status.
  std::uint64_t GetNumberOfLateScans() const { return this->LateScans; }
  /// Why the last scan failed. Empty if it succeeded.
  std::string GetProblem() const;

private:
  using Clock = std::chrono::steady_clock;

  void Run();
  /// Returns false if the scan was aborted.
  bool MakeScan();
  /// Returns the memory of large scans to the system after they are gone.
  void ReleaseMemory();
  void SetProblem(const std::string& problem);
  /// The time of the next scan, after a scan that was due at `due`.
  Clock::time_point GetNext(Clock::time_point due);
  /// Sleeps until `time` or new settings. Returns false if the loop is to end.
  bool SleepUntil(Clock::time_point time);

  lms3dSettingsBoard& Board;
  lms3dSnapshotStore& Store;
  const Clock::duration Period;
  const std::uint64_t Incarnation;
  lms3dScanPipeline Pipeline;
  /// Null without such a map.
  std::unique_ptr<lms3dFusedMapMaker> FusedMap;
  std::uint64_t Number = 0;
  /// The generation of the last scan, also if it was aborted. 0 before the first.
  std::uint64_t Generation = 0;
  int AbortedInARow = 0;
  /// The largest memory of all kept scans since ReleaseMemory() returned memory.
  std::size_t MaximumBytes = 0;
  std::atomic<std::uint64_t> LateScans{ 0 };
  mutable std::mutex Mutex;
  bool Stopped = false;
  std::string Problem;
  std::thread Thread;
};

#endif
